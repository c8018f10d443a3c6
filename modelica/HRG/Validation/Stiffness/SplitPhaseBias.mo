within HRG.Validation.Stiffness;
model SplitPhaseBias "Frequency split dw with a phase error p: a bias of -(dw p/4k) sin 4(theta - theta_w); the split alone: none"
  extends BaseClasses.BiasAtRest(
    gyro(
      resonator(material(frequencySplit = split, stiffnessAxis = axis)),
      pickOff(phaseError = present*phaseError)));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
  parameter Units.Angle phaseError = 1e-3 "p, of demodulation";
equation
  measured = bias.rate;
  expected = -split*phaseError/(4*k)*sin(4*(theta - axis));
  scale = split*phaseError/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(dw p/4k) sin 4(theta - theta_w): a quadrature force that is p out of phase turns the pattern. Mechanism 7;
the negative control, with the split and without the phase error, is mechanism 9.</p>
</html>"));
end SplitPhaseBias;
