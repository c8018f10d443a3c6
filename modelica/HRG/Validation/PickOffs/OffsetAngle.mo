within HRG.Validation.PickOffs;
model OffsetAngle "Demodulation offset x0: an angle error of (x0/2k) sin 2 theta, a second harmonic"
  extends BaseClasses.Turning(tolerance = 0.01, gyro(pickOff(offset = present*offset)));
  parameter Units.Displacement offset = 1e-3 "x0, over the amplitude";
equation
  measured = angleError;
  expected = offset/(2*k)*sin(2*theta);
  scale = offset/(2*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Angle +(x0/2k) sin 2 theta: mechanism 12. An additive offset is no anisotropy; it sees the sign of the wave, hence
the second harmonic.</p>
</html>"));
end OffsetAngle;
