within HRG.Validation;
package MassDefects "Harmonics of the rim's mass"
  annotation (Documentation(info="<html>
<p>What they make of the damping, by the support, and of vibration of the case.</p>
</html>"));
end MassDefects;
