within HRG.Validation.Drives;
model GainMismatchBias "Drive gain mismatch: a bias of (g/4k tau) sin 4 theta"
  extends BaseClasses.BiasAtRest(gyro(drive(gainMismatch = present*mismatch)));
  parameter Units.DimensionlessRatio mismatch = 1e-3 "g";
equation
  measured = bias.rate;
  expected = mismatch/(4*k*tau)*sin(4*theta);
  scale = mismatch/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = +(g/4k tau) sin 4 theta: the force that sustains the amplitude misses the antinode by (g/4) sin 4 theta.
Mechanism 3; at rest drives and pick-offs can't be told apart.</p>
</html>"));
end GainMismatchBias;
