within HRG.Controls;
function sensed "Reading of a steadily turning pattern behind a filter"
  input Units.RelativeDisplacement reading[4] "Reading {cx, sx, cy, sy}";
  input Units.DimensionlessRatio along "Response of the filter to the turning pattern, in line with it";
  input Units.DimensionlessRatio across "Response a quarter of a modal turn behind";
  output Units.RelativeDisplacement result[4] "Reading as the loops have it";
algorithm
  result[1] := along*reading[1] + across*reading[3];
  result[2] := along*reading[2] + across*reading[4];
  result[3] := along*reading[3] - across*reading[1];
  result[4] := along*reading[4] - across*reading[2];
  annotation (Documentation(info="<html>
<p>A pattern that the filter turns back by the angle of its response.</p>
</html>"));
end sensed;
