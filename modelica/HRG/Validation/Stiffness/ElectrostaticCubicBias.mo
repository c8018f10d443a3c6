within HRG.Validation.Stiffness;
model ElectrostaticCubicBias "Cubic softening of eight electrodes with a phase error p: a bias of -(delta p/8k) a^2 sin 8 theta"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(material(electrostaticCubic = present*cubic)), pickOff(phaseError = phaseError)));
  parameter Units.AngularFrequency cubic = 0.02 "delta, at unit amplitude";
  parameter Units.Angle phaseError = 1e-3 "p, of demodulation";
equation
  measured = bias.rate;
  expected = -cubic*phaseError/(8*k)*sin(8*theta);
  scale = cubic*phaseError/(8*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The quadrature force p out of phase turns the pattern, as in mechanism 7. Mechanism 33.</p>
</html>"));
end ElectrostaticCubicBias;
