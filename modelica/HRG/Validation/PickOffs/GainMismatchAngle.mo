within HRG.Validation.PickOffs;
model GainMismatchAngle "Pick-off gain mismatch g: a rate error of -g W cos 4 theta, an angle error of (g/4k) sin 4 theta"
  extends BaseClasses.Turning(tolerance = 0.01, gyro(pickOff(gainMismatch = present*mismatch)));
  parameter Units.DimensionlessRatio mismatch = 1e-3 "g";
equation
  measured = angleError;
  expected = mismatch/(4*k)*sin(4*theta);
  scale = mismatch/(4*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Angle +(g/4k) sin 4 theta; its derivative by d theta = -k W dt is the rate error -g W cos 4 theta. Mechanism 2: tan
2 theta is read too small by 1 - g. Even in the rate, unlike a bias.</p>
</html>"));
end GainMismatchAngle;
