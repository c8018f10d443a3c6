within HRG.Electrodes;
function fitted "Least-squares amplitudes at the end of a window; the previous ones where its samples don't determine them"
  input Real sums[17] "{x c, x s, y c, y s, c c, c s, s s} over the window, the same times t, and {c c, c s, s s} times t^2";
  input Units.RelativeDisplacement previous[4] "{cx, sx, cy, sy} of the last window";
  output Units.RelativeDisplacement result[4] "{cx, sx, cy, sy}";
protected
  Real spread "Determinant of the sums times t^2";
  Real scale "Its inverse; 0 where a window has no slopes to show";
  Real share[4] "Of the slope's equations in the amplitudes', {11, 12, 21, 22}";
  Real left[3] "Of {c c, c s, s s} beside the slopes";
  Real pull[4] "Of {x c, x s, y c, y s} beside the slopes";
  Real determinant "Of what is left";
algorithm
  spread := sums[15]*sums[17] - sums[16]*sums[16];
  scale := if spread > 1 then 1/spread else 0;
  share[1] := scale*(sums[12]*sums[17] - sums[13]*sums[16]);
  share[2] := scale*(sums[13]*sums[15] - sums[12]*sums[16]);
  share[3] := scale*(sums[13]*sums[17] - sums[14]*sums[16]);
  share[4] := scale*(sums[14]*sums[15] - sums[13]*sums[16]);
  left[1] := sums[5] - share[1]*sums[12] - share[2]*sums[13];
  left[2] := sums[6] - share[1]*sums[13] - share[2]*sums[14];
  left[3] := sums[7] - share[3]*sums[13] - share[4]*sums[14];
  pull[1] := sums[1] - share[1]*sums[8] - share[2]*sums[9];
  pull[2] := sums[2] - share[3]*sums[8] - share[4]*sums[9];
  pull[3] := sums[3] - share[1]*sums[10] - share[2]*sums[11];
  pull[4] := sums[4] - share[3]*sums[10] - share[4]*sums[11];
  determinant := left[1]*left[3] - left[2]*left[2];
  result[1] := if determinant > 1 then (left[3]*pull[1] - left[2]*pull[2])/determinant else previous[1];
  result[2] := if determinant > 1 then (left[1]*pull[2] - left[2]*pull[1])/determinant else previous[2];
  result[3] := if determinant > 1 then (left[3]*pull[3] - left[2]*pull[4])/determinant else previous[3];
  result[4] := if determinant > 1 then (left[1]*pull[4] - left[2]*pull[3])/determinant else previous[4];
  annotation (Documentation(info="<html>
<p>With A0, A1, A2 the matrices [[cc, cs], [cs, ss]] weighted with the powers of time, b0 and b1 the same of [x c; x s] (y alike), p the
amplitudes at the end of the window and v their slopes,</p>
<pre>[[A0, A1], [A1, A2]] [p; v] = [b0; b1], so (A0 - A1 inv(A2) A1) p = b0 - A1 inv(A2) b1</pre>
</html>"));
end fitted;
