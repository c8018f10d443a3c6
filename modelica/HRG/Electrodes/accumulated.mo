within HRG.Electrodes;
function accumulated "Sums of the least-squares demodulation, one sample on"
  input Real sums[7] "{x c, x s, y c, y s, c c, c s, s s}";
  input Real keep "0 where a new window begins, 1 within it";
  input Units.Displacement converted[2] "Sample {x, y}";
  input Units.Ratio carrier[2] "Cosine and sine of the reference oscillator's phase";
  output Real result[7] "Sums with this sample";
algorithm
  result[1] := keep*sums[1] + converted[1]*carrier[1];
  result[2] := keep*sums[2] + converted[1]*carrier[2];
  result[3] := keep*sums[3] + converted[2]*carrier[1];
  result[4] := keep*sums[4] + converted[2]*carrier[2];
  result[5] := keep*sums[5] + carrier[1]*carrier[1];
  result[6] := keep*sums[6] + carrier[1]*carrier[2];
  result[7] := keep*sums[7] + carrier[2]*carrier[2];
  annotation (Documentation(info="<html>
<p>The entries of the normal equations: sums of x c, x s, y c, y s, c c, c s and s s over the samples of a window.</p>
</html>"));
end accumulated;
