within HRG.Validation.ElectrodeRing;
model FourthHarmonicPump "Fourth harmonic of the gap under parametric drive: three quarters of the bias that it makes of forces"
  extends BaseClasses.BiasAtRest(
    tolerance = 0.01,
    gyro(
      controller(parametricShare = 1),
      ring(electrodes = 16, fourthHarmonic = present*harmonic, fourthAxis = axis)));
  parameter Units.DimensionlessRatio harmonic = 5e-4 "E, of the gap";
  parameter Units.Angle axis = 0.2 "Azimuth of a widest gap";
equation
  measured = bias.rate;
  expected = -3*harmonic/(4*k*tau)*sin(4*(theta - axis));
  scale = 3*harmonic/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>A ring that pumps by its bias voltage does so through the gap's inverse cube: n = -(3/2) E along the widest gap. Mechanisms 32 and 37:
B = -(3E/4k tau) sin 4(theta - theta_4), where pick-offs and drives of the same gap make -(E/k tau) sin 4(theta - theta_4).</p>
</html>"));
end FourthHarmonicPump;
