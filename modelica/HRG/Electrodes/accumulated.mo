within HRG.Electrodes;
function accumulated "Sums of the least-squares demodulation, one sample on"
  input Real sums[17] "{x c, x s, y c, y s, c c, c s, s s}, the same times t, and {c c, c s, s s} times t^2";
  input Real keep "0 where a new window begins, 1 within it";
  input Units.DimensionlessRatio place "Time t of this sample, in windows; 0 at the end";
  input Real weight "Of this sample";
  input Units.RelativeDisplacement converted[2] "Sample {x, y}";
  input Units.DimensionlessRatio carrier[2] "Cosine and sine of the reference oscillator's phase";
  output Real result[17] "Sums with this sample";
protected
  Real products[7] "{x c, x s, y c, y s, c c, c s, s s}";
algorithm
  products[1] := weight*converted[1]*carrier[1];
  products[2] := weight*converted[1]*carrier[2];
  products[3] := weight*converted[2]*carrier[1];
  products[4] := weight*converted[2]*carrier[2];
  products[5] := weight*carrier[1]*carrier[1];
  products[6] := weight*carrier[1]*carrier[2];
  products[7] := weight*carrier[2]*carrier[2];
  for i in 1:7 loop
    result[i] := keep*sums[i] + products[i];
    result[7 + i] := keep*sums[7 + i] + place*products[i];
  end for;
  for i in 1:3 loop
    result[14 + i] := keep*sums[14 + i] + place*place*products[4 + i];
  end for;
  annotation (Documentation(info="<html>
<p>The entries of the normal equations: sums of x c, x s, y c, y s, c c, c s and s s over the samples of a window, weighted with the
powers 0, 1 and 2 of time.</p>
</html>"));
end accumulated;
