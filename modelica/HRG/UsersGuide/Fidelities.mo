within HRG.UsersGuide;
class Fidelities "What is modelled how finely, and what is not"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>Three gyros of one library, with the same inputs, outputs and error parameters:</p>
<ul>
<li><code>Gyroscopes.HRGEnvelope</code>, the one to begin with: the vibration by its complex envelope, the average over a carrier period, in
continuous time; the electronics sample by sample at 1 kHz. What the loops do within milliseconds is in it, what averages out
within a carrier period is not.</li>
<li><code>Gyroscopes.HRGCarrier</code>: the oscillator at its carrier, converters and demodulation, the same electronics. For short
checks of the envelope.</li>
<li><code>Gyroscopes.HRGSlow</code>: the loops are taken as settled, so that only the pattern moves and a step may last a second. For
hours and for thousands of gyros. Loops that overload or hunt are not in it.</li>
</ul>
<p>In all of them the temperature is one number with a lag, vibration acts where it meets the modal frequency, and geometry
enters by the Bryan factor and by mismatches: there is no finite-element shell.</p>
<p>Models of <code>Validation</code> take the gyro as a replaceable class, <code>Gyro</code>; the tests hold <code>HRGEnvelope</code> and
<code>HRGSlow</code> to the same claims.</p>
</html>"));
end Fidelities;
