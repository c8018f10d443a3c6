within HRG.Controls;
function smoothed "Reading behind a low-pass filter of first order, one sample on"
  input Units.RelativeDisplacement previous[4] "Filtered reading at the sample before";
  input Units.RelativeDisplacement reading[4] "Reading at this sample";
  input Units.DimensionlessRatio share "Share of the difference that this sample takes away; 1: no filter, 0: the reading is not taken";
  output Units.RelativeDisplacement result[4] "Filtered reading";
algorithm
  for i in 1:4 loop
    result[i] := if share >= 1 then reading[i] elseif share <= 0 then previous[i] else previous[i] + share*(reading[i] - previous[i]);
  end for;
  annotation (Documentation(info="<html>
<p>y(n) = y(n - 1) + s (x(n) - y(n - 1)), without rounding for s = 1 and s = 0.</p>
</html>"));
end smoothed;
