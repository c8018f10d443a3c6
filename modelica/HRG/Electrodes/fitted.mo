within HRG.Electrodes;
function fitted "Least-squares amplitudes of a window; the previous ones where its samples don't determine them"
  input Real sums[7] "{x c, x s, y c, y s, c c, c s, s s} over the window";
  input Units.Displacement previous[4] "{cx, sx, cy, sy} of the last window";
  output Units.Displacement result[4] "{cx, sx, cy, sy}";
protected
  Real determinant "Of the normal equations, a quarter of the squared number of samples";
algorithm
  determinant := sums[5]*sums[7] - sums[6]*sums[6];
  result[1] := if determinant > 1 then (sums[7]*sums[1] - sums[6]*sums[2])/determinant else previous[1];
  result[2] := if determinant > 1 then (sums[5]*sums[2] - sums[6]*sums[1])/determinant else previous[2];
  result[3] := if determinant > 1 then (sums[7]*sums[3] - sums[6]*sums[4])/determinant else previous[3];
  result[4] := if determinant > 1 then (sums[5]*sums[4] - sums[6]*sums[3])/determinant else previous[4];
  annotation (Documentation(info="<html>
<p>Solution of the normal equations [[cc, cs], [cs, ss]] [cx; sx] = [x c; x s], y alike, by Cramer's rule.</p>
</html>"));
end fitted;
