within HRG.Validation;
package Stiffness "Frequency split, quadrature, and stiffness that grows with amplitude"
  annotation (Documentation(info="<html>
<p>What the frequency split does with phase errors and quadrature, and what a cubic stiffness does.</p>
</html>"));
end Stiffness;
