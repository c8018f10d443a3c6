within HRG;
package Controls "Sampled control electronics"
  annotation (Documentation(info="<html>
<p>From a reading to forces and to the output angle, once in a control period: detection, start-up, loops, compensation, read-out.</p>
</html>"));
end Controls;
