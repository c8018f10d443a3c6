within HRG;
package Gyroscopes "Complete gyros: the roots that are exported"
  annotation (Documentation(info="<html>
<p>The three gyros that become FMUs, and resonator and electronics of the first one by themselves. The gyros have the inputs, outputs and parameters of <code>Interfaces.PartialGyro</code>;
<code>UsersGuide.Fidelities</code> says which is for what.</p>
</html>"));
end Gyroscopes;
