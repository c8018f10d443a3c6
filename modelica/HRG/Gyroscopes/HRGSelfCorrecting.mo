within HRG.Gyroscopes;
model HRGSelfCorrecting "Whole-angle hemispherical resonator gyro that estimates the change of its bias map and takes it out"
  extends HRGEnvelope(redeclare Controls.EstimatingController controller);
  annotation (Documentation(info="<html>
<p><code>HRGEnvelope</code> with <code>Controls.EstimatingController</code>. With the estimator's parameters at zero, their default, the outputs are the same to the bit.</p>
</html>"));
end HRGSelfCorrecting;
