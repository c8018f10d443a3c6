within HRG.UsersGuide;
class Overview "What the library models"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>A hemispherical resonator gyro in whole-angle mode: a shell vibrates in its n = 2 mode, the pattern of the vibration
precesses by -k times the angle of the case, and the electronics read the angle of the pattern. They also hold its
amplitude and its quadrature, keep in phase with it, and turn it on command.</p>
<ul>
<li><code>Gyroscopes</code>: complete gyros, the models to use.</li>
<li><code>Resonators</code>, <code>Electrodes</code>, <code>Controls</code>, <code>Noise</code>, <code>Interfaces</code>: their parts.</li>
<li><code>Examples</code>: small models to open first.</li>
<li><code>Validation</code>: one claim a model, its closed form beside what the gyro shows.</li>
</ul>
<p>The diagram of <code>Gyroscopes.HRGEnvelope</code> shows the parts connected. Its <code>controller</code> is replaceable by any block that extends
<code>Interfaces.PartialElectronics</code>, as <code>Examples.ReplacedElectronics</code> shows. Specific force, temperatures and gradients reach the parts by modifiers and are not drawn.</p>
<p>Every error mechanism is a parameter of the part where it lives, zero by default: a gyro as it is dropped into a model is
an ideal one. Its inputs are those of a device: inertial rate, specific force, temperature, supply, commands.</p>
</html>"));
end Overview;
