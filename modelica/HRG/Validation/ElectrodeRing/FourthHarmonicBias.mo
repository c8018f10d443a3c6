within HRG.Validation.ElectrodeRing;
model FourthHarmonicBias "Fourth harmonic of the gap under sixteen electrodes: a bias of the fourth harmonic alone"
  extends BaseClasses.BiasAtRest(
    gyro(ring(electrodes = 16, fourthHarmonic = present*harmonic, fourthAxis = axis)));
  parameter Units.DimensionlessRatio harmonic = 5e-4 "Over the mean gap";
  parameter Units.Angle axis = 0.3 "Of a widest gap";
equation
  measured = bias.rate;
  expected = -harmonic/(k*tau)*sin(4*(theta - axis));
  scale = harmonic/(k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>g = gd = -2 E cos 4 phi_4, d = nd = -e = -2 E sin 4 phi_4: the force that sustains the amplitude is misaimed twice, by pick-offs and drives,
and the constant part cancels, since electrodes drive as they read. Mechanism 32.</p>
</html>"));
end FourthHarmonicBias;
