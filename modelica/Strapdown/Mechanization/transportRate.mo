within Strapdown.Mechanization;
function transportRate "Rotation rate of the navigation axes against Earth, rad/s"
  input Real average[3] "Mean velocity, north, east, down, m/s";
  input Real place[7] "Of function middle";
  output Real rate[3] "North, east, down, rad/s";
protected
  Real north "Rate about north, rad/s";
algorithm
  north := average[2]/place[5];
  rate := {north, -average[1]/place[4], -north*place[1]/place[2]};
  annotation (Documentation(info="<html>
<p>Eq. 10; Groves 2013, Eq. 5.44.</p>
</html>"));
end transportRate;
