within HRG.Electrodes;
function digitised "Value within full scale, rounded to the resolution"
  input Real value "To be digitised";
  input Real resolution "Least significant bit; 0: none";
  input Real fullScale "Largest magnitude; 0: none";
  output Real result "Digitised value";
protected
  Real clipped "Within full scale";
algorithm
  clipped := if fullScale <= 0 then value elseif value > fullScale then fullScale elseif value < -fullScale then -fullScale else value;
  result := if resolution <= 0 then clipped else resolution*floor(clipped/resolution + 0.5);
  annotation (Documentation(info="<html>
<p>Clipped at the full scale, then rounded to the nearest multiple of the resolution.</p>
</html>"));
end digitised;
