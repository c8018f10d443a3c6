within Strapdown.Mechanization;
function middle "The middle of a step, from its start and its mean velocity"
  input Real latitude "Geodetic latitude at the start, rad";
  input Real height "Above the ellipsoid at the start, m";
  input Real average[3] "Mean velocity, north, east, down, m/s";
  input Real interval "Duration of the step, s";
  output Real place[7] "{sine and cosine of latitude; height, m; meridian and transverse radius plus height, m; gravity down and north, m/s2}";
protected
  Real there "Latitude of the middle, rad";
  Real above "Height of the middle, m";
algorithm
  there := latitude + 0.5*interval*average[1]/(Earth.meridianRadius(latitude) + height);
  above := height - 0.5*interval*average[3];
  place := {
    sin(there),
    cos(there),
    above,
    Earth.meridianRadius(there) + above,
    Earth.transverseRadius(there) + above,
    Earth.gravity(there, above),
    Earth.northGravity(there, above)};
  annotation (Documentation(info="<html>
<p>Earth's rate, transport rate, Coriolis acceleration and gravity are evaluated there.</p>
</html>"));
end middle;
