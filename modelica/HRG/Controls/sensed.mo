within HRG.Controls;
function sensed "Reading of a steadily turning pattern behind a filter and under forces in time division"
  input Units.RelativeDisplacement reading[4] "Reading {cx, sx, cy, sy}";
  input Units.Angle lag "Modal angle by which the pattern turns in the filter's delay";
  input Units.RelativeDisplacement sag[4] "Displacement below its mean at the end of a period without force";
  output Units.RelativeDisplacement result[4] "Reading as the loops have it";
protected
  Units.DimensionlessRatio attenuation "Of the part in line with the pattern";
algorithm
  attenuation := 1/(1 + lag*lag);
  result[1] := (reading[1] + lag*reading[3])*attenuation - sag[1];
  result[2] := (reading[2] + lag*reading[4])*attenuation - sag[2];
  result[3] := (reading[3] - lag*reading[1])*attenuation - sag[3];
  result[4] := (reading[4] - lag*reading[2])*attenuation - sag[4];
  annotation (Documentation(info="<html>
<p>A filter of first order, 1/(1 + s d), makes of exp(i alpha) with alpha' = u/d the share 1/(1 + i u).</p>
</html>"));
end sensed;
