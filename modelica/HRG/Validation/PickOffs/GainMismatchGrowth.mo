within HRG.Validation.PickOffs;
model GainMismatchGrowth "Pick-off gain mismatch: an amplitude force of -(g/2 tau) cos 4 theta"
  extends BaseClasses.GrowthAtRest(gyro(pickOff(gainMismatch = present*mismatch)));
  parameter Units.DimensionlessRatio mismatch = 1e-3 "g";
equation
  expected = -mismatch/(2*tau)*cos(4*theta);
  scale = mismatch/(2*tau);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>G = (1/tau)(1 - (g/2) cos 4 theta): more gain along the antinode, less force. Mechanism 2.</p>
</html>"));
end GainMismatchGrowth;
