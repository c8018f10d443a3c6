within HRG;
package Electrodes "Between shell and electronics: pick-offs and drives"
  annotation (Documentation(info="<html>
<p>Displacements become readings in a pick-off, commands become forces in a drive; their errors stand here.</p>
</html>"));
end Electrodes;
