within HRG.Validation.Environment;
model ImbalanceBias "Vibration at the modal frequency on an imbalance: a bias of (f/2k a) sin 2 theta, a second harmonic"
  extends BaseClasses.BiasAtRest(
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      vibration = vibration,
      resonator(imbalanceX = present*imbalance)));
  parameter Units.Acceleration vibration = 1 "Of the case, in phase";
  parameter Real imbalance(unit = "s/m") = 1e-6 "Force on x over vibration";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = bias.rate;
  expected = imbalance*vibration/(2*k*amplitude)*sin(2*theta);
  scale = imbalance*vibration/(2*k*amplitude);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>A force f on x has -f sin 2 theta on the node and drives the pattern at -(f/2a) sin 2 theta: mechanism 27.</p>
</html>"));
end ImbalanceBias;
