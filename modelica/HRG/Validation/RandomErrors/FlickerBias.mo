within HRG.Validation.RandomErrors;
model FlickerBias "Coefficients that flicker make the bias that steady ones make, at every moment"
  extends BaseClasses.BiasAtRest(
    tolerance = 0.01,
    gyro(
      seed = 1,
      resonator(material(
        dampingAnisotropy = present*anisotropy,
        dampingAxis = axis,
        frequencySplit = split,
        stiffnessAxis = splitAxis)),
      flicker(
        dampingAnisotropy = present*dampingInstability,
        gainMismatch = present*gainInstability,
        phaseError = present*phaseInstability)));
  parameter Units.DampingCoefficient anisotropy = 1e-8 "D";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.AngularFrequency split = 1.5e-3 "dw";
  parameter Units.Angle splitAxis = 0.6 "Of the mode of lower frequency";
  parameter Units.DimensionlessRatio dampingInstability = 0.3 "B of D, relative to it";
  parameter Units.DimensionlessRatio gainInstability = 1e-6 "B of g";
  parameter Units.Angle phaseInstability = 3e-6 "B of p";
protected
  Real total[3](each start = 0, each fixed = true) "Integrals of the changes of D, g and p";
  BaseClasses.MeanRate damping(samplePeriod = gyro.samplePeriod, angle = total[1]) "Mean change of D";
  BaseClasses.MeanRate gain(samplePeriod = gyro.samplePeriod, angle = total[2]) "Mean change of g";
  BaseClasses.MeanRate phase(samplePeriod = gyro.samplePeriod, angle = total[3]) "Mean change of p";
  BaseClasses.MeanRate gainRate(samplePeriod = gyro.samplePeriod, angle = gyro.flicker.gain) "Mean rate of g";
equation
  der(total) = {gyro.flicker.damping, gyro.flicker.gain, gyro.flicker.phase};
  measured = bias.rate;
  expected = -anisotropy*(1 + damping.rate)/(4*k)*sin(4*(theta - axis)) + (gain.rate/tau + gainRate.rate)/(4*k)*sin(4*theta)
    - split*phase.rate/(4*k)*sin(4*(theta - splitAxis));
  scale = (anisotropy + gainInstability/tau + split*phaseInstability)/(4*k);
  annotation (experiment(StopTime = 110), Documentation(info="<html>
<p>As mechanisms 1, 2 and 7 with D (1 + x), g = x and p = x, x what <code>CoefficientFlicker</code> gives, in the mean over the test; g is read as an angle as well. Mechanism 38; its spectrum is
that of <code>DampingFlicker</code>. 0.8 % are the lag of loops that settle in a second: <code>HRGSlow</code> follows a phase by 0.3 s.</p>
</html>"));
end FlickerBias;
