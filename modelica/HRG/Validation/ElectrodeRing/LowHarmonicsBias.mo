within HRG.Validation.ElectrodeRing;
model LowHarmonicsBias "Eccentricity with a third harmonic, and a second harmonic of the gap, act as a fourth"
  extends BaseClasses.BiasAtRest(
    tolerance = 0.01,
    gyro(ring(
      electrodes = 16,
      eccentricity = present*eccentricity,
      eccentricityAxis = 0.5,
      secondHarmonic = present*second,
      secondAxis = 0.8,
      thirdHarmonic = present*third,
      thirdAxis = 1.1)));
  parameter Units.DimensionlessRatio eccentricity = 0.004 "Over the mean gap";
  parameter Units.DimensionlessRatio second = 0.002 "Over the mean gap";
  parameter Units.DimensionlessRatio third = 0.002 "Over the mean gap";
equation
  measured = bias.rate;
  expected = (1.5*eccentricity*third*sin(4*theta - 0.5 - 3*1.1) + 0.75*second^2*sin(4*(theta - 0.8)))/(k*tau);
  scale = 1.5*eccentricity*third/(k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>1/(1 + E)^2 has 3 E^2, in which a first and a third harmonic make (3/2) E1 E3 of the fourth, twice a second (3/4) E2^2. Mechanism 32.</p>
</html>"));
end LowHarmonicsBias;
