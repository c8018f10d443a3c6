within HRG;
package Gyroscopes "Complete gyros: the roots that are exported"
  annotation (Documentation(info="<html>
<p>The three gyros that become FMUs. All have the inputs, outputs and parameters of <code>Interfaces.PartialGyro</code>;
<code>UsersGuide.Fidelities</code> says which is for what.</p>
</html>"));
end Gyroscopes;
