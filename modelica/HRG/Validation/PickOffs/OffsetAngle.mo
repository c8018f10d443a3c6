within HRG.Validation.PickOffs;
model OffsetAngle "Demodulation offset x0: an angle error of (x0/2k a) sin 2 theta, a second harmonic"
  extends BaseClasses.Turning(
    tolerance = 0.01,
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      pickOff(offset = present*offset)));
  parameter Units.RelativeDisplacement offset = 1e-3 "x0, over the nominal amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = angleError;
  expected = offset/(2*k*amplitude)*sin(2*theta);
  scale = offset/(2*k*amplitude);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Angle +(x0/2k a) sin 2 theta: mechanism 12. An additive offset is no anisotropy: it sees the sign of
the wave, hence the second harmonic, and weighs less the larger the amplitude.</p>
</html>"));
end OffsetAngle;
