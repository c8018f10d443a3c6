within Strapdown.Earth;
function transverseRadius "Radius of curvature of the prime vertical, m"
  input Real latitude "Geodetic latitude, rad";
  output Real radius "Radius of curvature, m";
algorithm
  radius := semiMajor/sqrt(1 - eccentricitySquared*sin(latitude)^2);
  annotation (Documentation(info="<html>
<p>Groves 2013, Eq. 2.106.</p>
</html>"));
end transverseRadius;
