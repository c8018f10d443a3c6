within HRG.Electrodes;
block PickOff "Displacement as the electronics see it"
  parameter Units.Ratio gainMismatch(min = -0.5, max = 0.5) = 0 "g: x reads (1 + g/2) x, y reads (1 - g/2) y";
  parameter Units.Ratio nonOrthogonality(min = -0.5, max = 0.5) = 0 "d: y reads y + d x";
  parameter Units.Angle phaseError(min = -1, max = 1, displayUnit = "rad") = 0
    "p: phase that the demodulation adds to both channels";
  input Units.Displacement envelope[4] "True displacement {cx, sx, cy, sy}";
  input Units.Displacement noise[4] "Noise of the demodulated channels";
  output Units.Displacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
protected
  final parameter Units.Ratio gainX = 1 + gainMismatch/2 "Gain of x";
  final parameter Units.Ratio gainY = 1 - gainMismatch/2 "Gain of y";
  final parameter Units.Ratio phaseCos = cos(phaseError) "Rotation by the phase error, diagonal";
  final parameter Units.Ratio phaseSin = sin(phaseError) "Rotation by the phase error, off diagonal";
  Units.Displacement cx "x in phase, before the phase error";
  Units.Displacement sx "x in quadrature, before the phase error";
  Units.Displacement cy "y in phase, before the phase error";
  Units.Displacement sy "y in quadrature, before the phase error";
equation
  cx = gainX*envelope[1];
  sx = gainX*envelope[2];
  cy = gainY*(envelope[3] + nonOrthogonality*envelope[1]);
  sy = gainY*(envelope[4] + nonOrthogonality*envelope[2]);
  reading = {
    phaseCos*cx + phaseSin*sx + noise[1],
    phaseCos*sx - phaseSin*cx + noise[2],
    phaseCos*cy + phaseSin*sy + noise[3],
    phaseCos*sy - phaseSin*cy + noise[4]};
  annotation (Documentation(info="<html>
<p>Non-orthogonality first, then gain, then phase: the complex envelope cx - i sx is multiplied by exp(i p).</p>
</html>"));
end PickOff;
