within HRG.Validation.ElectrodeRing;
model Softening "Fourth harmonic of the gap: the bias voltage softens the shell unevenly and splits the frequencies"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeForce,
    tolerance = 0.01,
    gyro(
      biasVoltage = voltage,
      ring(coverage = coverage, fourthHarmonic = present*harmonic, fourthAxis = axis),
      resonator(material(electrostaticShift = shift))));
  parameter Units.AngularFrequency shift = 2*Constants.pi*1 "Of the mean frequency at the nominal voltage";
  parameter Units.DimensionlessRatio voltage = 1.1 "V, over the nominal one";
  parameter Units.DimensionlessRatio harmonic = 2e-3 "Over the mean gap";
  parameter Units.Angle axis = 0.3 "Of a widest gap";
  parameter Units.DimensionlessRatio coverage = 0.8 "Width of an electrode over the pitch";
protected
  final parameter Units.DimensionlessRatio j = sin(Constants.pi*coverage)/(2*Constants.pi*coverage) "By the width";
equation
  measured = gyro.quadratureForce;
  expected = -3*harmonic*shift*(voltage^2 - 1)*((0.5 + j)*cos(4*axis)*sin(4*theta) - (0.5 - j)*sin(4*axis)*cos(4*theta));
  scale = 1.5*harmonic*shift*(voltage^2 - 1);
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>The softening goes with V^2/gap^3. With S the mean one, b half the width of one of eight electrodes and j = sin 8b/(16 b), the stiffness anisotropy
{cos, sin} is -3 E S (V^2 - 1) {(1/2 + j) cos 4 phi_4, (1/2 - j) sin 4 phi_4}, seen as mechanism 9. Mechanisms 25 and 32.</p>
</html>"));
end Softening;
