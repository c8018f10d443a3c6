within HRG.Electrodes;
block Ring "Ring of electrodes around the shell: what an uneven gap makes of pick-offs, drives and softening"
  parameter Integer electrodes(min = 8, max = 16) = 8 "Electrodes of the ring, 8 or 16, each a pick-off and a drive";
  parameter Units.DimensionlessRatio coverage(min = 0.01, max = 1) = 0.9 "Width of an electrode over the pitch, typically 0.8 to 0.95";
  parameter Units.DimensionlessRatio eccentricity(min = 0, max = 0.2) = 0
    "First harmonic of the gap over its mean, by a shell off the centre or tilted, typically 0.005 to 0.05 (estimate)";
  parameter Units.Angle eccentricityAxis(min = -1000, max = 1000) = 0 "Azimuth of its widest gap";
  parameter Units.DimensionlessRatio secondHarmonic(min = 0, max = 0.2) = 0 "Second harmonic of the gap over its mean, typically 1e-3 to 1e-2 (estimate)";
  parameter Units.Angle secondAxis(min = -1000, max = 1000) = 0 "Azimuth of a widest gap of it";
  parameter Units.DimensionlessRatio thirdHarmonic(min = 0, max = 0.2) = 0 "Third harmonic of the gap over its mean, typically 1e-3 to 1e-2 (estimate)";
  parameter Units.Angle thirdAxis(min = -1000, max = 1000) = 0 "Azimuth of a widest gap of it";
  parameter Units.DimensionlessRatio fourthHarmonic(min = 0, max = 0.2) = 0 "Fourth harmonic of the gap over its mean, typically 2e-4 to 5e-3 (estimate)";
  parameter Units.Angle fourthAxis(min = -1000, max = 1000) = 0 "Azimuth of a widest gap of it";
  final parameter Units.DimensionlessRatio errors[9] = ringErrors(
    electrodes, Constants.pi/electrodes*coverage,
    {eccentricity*cos(eccentricityAxis), secondHarmonic*cos(2*secondAxis), thirdHarmonic*cos(3*thirdAxis), fourthHarmonic*cos(4*fourthAxis)},
    {eccentricity*sin(eccentricityAxis), secondHarmonic*sin(2*secondAxis), thirdHarmonic*sin(3*thirdAxis), fourthHarmonic*sin(4*fourthAxis)})
    "As of ringErrors";
  annotation (Icon(graphics = {Ellipse(extent = {{-90, 90}, {90, -90}}), Ellipse(extent = {{-70, 70}, {70, -70}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>The gap is d(1 + E), E its harmonics over the mean; electrode j at 2 pi j/n reads the shell's displacement over its width with a gain of
1/(1 + E)^2, and the electronics add the electrodes weighted by cos 2 phi_j for x, sin 2 phi_j for y. A force is the same sum the other way
round, so that the matrix of the drives is the transpose of that of the pick-offs. <code>ringErrors</code> turns both into the gain mismatch,
non-orthogonality and frame rotation that <code>PickOff</code> and <code>DriveErrors</code> have, so that a tick costs no more.</p>
<p>Mechanism 32. With E4 = fourthHarmonic exp(4i fourthAxis) - (3/2) eccentricity thirdHarmonic exp(i (eccentricityAxis + 3 thirdAxis)) -
(3/4) secondHarmonic^2 exp(4i secondAxis), b half an electrode's width and j = sin 6b/(6 sin 2b) of 8 electrodes, 0 of 16, to leading order</p>
<pre>g = gd = -(2 + 4j) Re E4,  d = nd = -(2 - 4j) Im E4,  e = -d</pre>
<p>d + nd + 2e = 0: a ring whose electrodes read and drive alike makes no mean bias. Eccentricity alone changes the scale of displacements and
forces, 1 + 3/2 E^2; with a third harmonic it acts as a fourth.</p>
</html>"));
end Ring;
