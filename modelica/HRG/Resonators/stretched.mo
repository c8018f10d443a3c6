within HRG.Resonators;
function stretched "One and a change, above zero for every change"
  input Real change(unit = "1") "Relative change";
  output Real result(unit = "1") "1 + change down to 1/2, then smoothly towards 0";
algorithm
  result := if change > -0.5 then 1 + change else -0.25/change;
  annotation (Documentation(info="<html>
<p>1 + u, for u below -1/2 with the same value and slope -1/(4 u): a linear law that no temperature takes through zero.</p>
</html>"));
end stretched;
