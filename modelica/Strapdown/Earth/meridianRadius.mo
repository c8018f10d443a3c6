within Strapdown.Earth;
function meridianRadius "Radius of curvature of the meridian, m"
  input Real latitude "Geodetic latitude, rad";
  output Real radius "Radius of curvature, m";
protected
  Real w "1 - e^2 sin^2 of the latitude";
algorithm
  w := 1 - eccentricitySquared*sin(latitude)^2;
  radius := semiMajor*(1 - eccentricitySquared)/(w*sqrt(w));
  annotation (Documentation(info="<html>
<p>Groves 2013, Eq. 2.105.</p>
</html>"));
end meridianRadius;
