within HRG.Controls;
block PatternDetector "Sampled orbit of the vibration"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Angle startAngle "Pattern angle to begin with";
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.Angle expected "Modal angle to which the detected one is nearest, of those that differ by pi";
  discrete output Units.Angle patternAngle(start = startAngle, fixed = true) "Pattern angle, continuous";
  discrete output Units.DimensionlessRatio cosine(start = cos(2*startAngle), fixed = true) "Of the modal angle";
  discrete output Units.DimensionlessRatio sine(start = sin(2*startAngle), fixed = true) "Of the modal angle";
  discrete output Units.RelativeDisplacement amplitude(start = 1, fixed = true) "Antinode amplitude";
  discrete output Units.RelativeDisplacement quadrature(start = 0, fixed = true) "Quadrature amplitude";
  discrete output Units.Angle phase(start = 0, fixed = true) "Phase of the antinode against the reference";
  discrete output Units.Angle lastAngle(start = startAngle, fixed = true) "Pattern angle at the last sample";
protected
  discrete Units.DimensionlessRatio detected[6](start = {2*startAngle, cos(2*startAngle), sin(2*startAngle), 1, 0, 0}, each fixed = true) "Result of the detection";
equation
  when tick then
    lastAngle = pre(patternAngle);
    detected = orbit(reading, expected);
    patternAngle = detected[1]/2;
    cosine = detected[2];
    sine = detected[3];
    amplitude = detected[4];
    quadrature = detected[5];
    phase = detected[6];
  end when;
  annotation (Documentation(info="<html>
<p>The elements of the orbit by <code>orbit</code>, once a sample (D. D. Lynch): alpha = atan2(S, R)/2 is the modal angle, the pattern angle
is half of it. Of the angles that differ by pi, the sign of the wave, the nearest to the expected one is taken, so that the
pattern angle is continuous while it stays within 45 degrees of what is expected.</p>
</html>"));
end PatternDetector;
