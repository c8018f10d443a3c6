within HRG.Validation;
package Drives "Errors of drive electrodes"
  annotation (Documentation(info="<html>
<p>Each is an error of a force; it shows while a force is needed, at rest as well.</p>
</html>"));
end Drives;
