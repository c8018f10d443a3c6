within HRG.Validation.PickOffs;
model CubicAngle "Cubic nonlinearity b of a pick-off: an angle error of (3 b a^2/32k) sin 8 theta, an eighth harmonic"
  extends BaseClasses.Turning(
    tolerance = 0.01,
    gyro(startAmplitude = amplitude, amplitudeSetpoint = amplitude, pickOff(cubic = present*cubic)));
  parameter Units.DimensionlessRatio cubic = 4e-3 "b";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = angleError;
  expected = 0.75*cubic*amplitude^2/(8*k)*sin(8*theta);
  scale = 0.75*cubic*amplitude^2/(8*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>A channel reads x(1 + (3/4) b x^2): tan 2 theta is off by (3/4) b a^2 (sin^2 - cos^2) of 2 theta, the angle by (3 b
a^2/32k) sin 8 theta. Mechanism 13; grows with a^2, here at half the amplitude.</p>
</html>"));
end CubicAngle;
