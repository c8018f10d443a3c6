within HRG.Validation.PickOffs;
model OffsetBias "Demodulation offset x0: a bias of (x0/2k tau) sin 2 theta, a second harmonic"
  extends BaseClasses.BiasAtRest(gyro(pickOff(offset = present*offset)));
  parameter Units.RelativeDisplacement offset = 1e-4 "x0, over the amplitude";
equation
  measured = bias.rate;
  expected = offset/(2*k*tau)*sin(2*theta);
  scale = offset/(2*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = (x0/2k tau) sin 2 theta: the sustaining force follows the angle read. Mechanism 12.</p>
</html>"));
end OffsetBias;
