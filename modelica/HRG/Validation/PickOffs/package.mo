within HRG.Validation;
package PickOffs "Errors of pick-offs, demodulation and converter"
  annotation (Documentation(info="<html>
<p>Each shows in the angle as read while the case turns, and in the bias by forces that the reading misleads.</p>
</html>"));
end PickOffs;
