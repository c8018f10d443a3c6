within HRG.UsersGuide;
class Fidelities "What is modelled how finely, and what is not"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p><code>Gyroscopes.HRG</code> models the vibration by its complex envelope, the average over a carrier period, in continuous
time, and the electronics sample by sample at 1 kHz. What averages out within a carrier period is not in it; what
the loops do within seconds is.</p>
<p>The temperature is one number with a lag. Vibration acts where it meets the modal frequency. Geometry enters by the
Bryan factor and by mismatches; there is no finite-element shell.</p>
<p>Models of <code>Validation</code> take the kind of gyro as a replaceable class, so that another fidelity can be held to the
same claims.</p>
</html>"));
end Fidelities;
