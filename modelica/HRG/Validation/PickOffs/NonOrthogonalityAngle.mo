within HRG.Validation.PickOffs;
model NonOrthogonalityAngle "Pick-off non-orthogonality d: an angle error of -(d/4k)(1 + cos 4 theta)"
  extends BaseClasses.Turning(tolerance = 0.01, gyro(pickOff(nonOrthogonality = present*skew)));
  parameter Units.DimensionlessRatio skew = 1e-3 "d";
equation
  measured = angleError;
  expected = -skew/(4*k)*(1 + cos(4*theta));
  scale = skew/(2*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Angle -(d/4k)(1 + cos 4 theta), rate error -d W sin 4 theta: mechanism 4, with y read as y + d x.</p>
</html>"));
end NonOrthogonalityAngle;
