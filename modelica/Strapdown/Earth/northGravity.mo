within Strapdown.Earth;
function northGravity "North component of normal gravity, m/s2"
  input Real latitude "Geodetic latitude, rad";
  input Real height "Above the ellipsoid, m";
  output Real north "North component, m/s2";
algorithm
  north := -plumbLine*height*sin(2*latitude);
  annotation (Documentation(info="<html>
<p>By the curvature of the plumb line: Groves 2013, Eq. 2.140; Eq. 14a without a deflection of the vertical.</p>
</html>"));
end northGravity;
