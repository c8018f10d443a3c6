within HRG.Validation.ElectrodeRing;
model FourthHarmonicAngle "Fourth harmonic of the gap: gain mismatch and non-orthogonality of the pick-offs, read in the angle"
  extends BaseClasses.Turning(
    tolerance = 0.01,
    gyro(ring(electrodes = 8, coverage = coverage, fourthHarmonic = present*harmonic, fourthAxis = axis)));
  parameter Units.DimensionlessRatio harmonic = 5e-4 "Over the mean gap";
  parameter Units.Angle axis = 0.3 "Of a widest gap";
  parameter Units.DimensionlessRatio coverage = 0.8 "Width of an electrode over the pitch";
protected
  final parameter Units.DimensionlessRatio j = sin(6*Constants.pi/8*coverage)/(6*sin(2*Constants.pi/8*coverage)) "By the width";
  final parameter Units.DimensionlessRatio g = -(2 + 4*j)*harmonic*cos(4*axis) "Gain mismatch";
  final parameter Units.DimensionlessRatio d = -(2 - 4*j)*harmonic*sin(4*axis) "Non-orthogonality";
equation
  measured = angleError;
  expected = g/(4*k)*sin(4*theta) - d/(4*k)*(1 + cos(4*theta));
  scale = harmonic/(2*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>A gap of d(1 + E cos 4(phi - phi_4)) and eight electrodes of half width b: with j = sin 6b/(6 sin 2b), g = -(2 + 4j) E cos 4 phi_4 and
d = -(2 - 4j) E sin 4 phi_4, as mechanisms 2 and 4. Mechanism 32.</p>
</html>"));
end FourthHarmonicAngle;
