within HRG;
package Interfaces "What a gyro and its electronics show to the outside"
  annotation (Documentation(info="<html>
<p>Connectors and power-on values of a gyro, whatever it is made of, and of its electronics; <code>Inputs</code> and <code>Outputs</code> are the kinds of connectors.</p>
</html>"));
end Interfaces;
