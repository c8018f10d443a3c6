within HRG.Validation.PickOffs;
model OffsetYAngle "Demodulation offset y0 of y: an angle error of -(y0/2k a) cos 2 theta, a second harmonic"
  extends BaseClasses.Turning(
    tolerance = 0.01,
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      pickOff(offsetY = present*offset)));
  parameter Units.RelativeDisplacement offset = 1e-3 "y0, over the nominal amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = angleError;
  expected = -offset/(2*k*amplitude)*cos(2*theta);
  scale = offset/(2*k*amplitude);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Angle -(y0/2k a) cos 2 theta: mechanism 12, as that of x (<code>OffsetAngle</code>) but 45 deg of pattern away. With both, the
second harmonic has any phase.</p>
</html>"));
end OffsetYAngle;
