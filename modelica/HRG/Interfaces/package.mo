within HRG;
package Interfaces "What a gyro shows to the outside"
  annotation (Documentation(info="<html>
<p>Inputs, outputs and power-on values of a gyro, whatever it is made of.</p>
</html>"));
end Interfaces;
