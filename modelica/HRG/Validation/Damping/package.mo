within HRG.Validation;
package Damping "Damping anisotropy of shell and mounting, and ring-down, which shows it without a drive"
  annotation (Documentation(info="<html>
<p>The bias and the growth rate of damping anisotropy, driven and without drive.</p>
</html>"));
end Damping;
