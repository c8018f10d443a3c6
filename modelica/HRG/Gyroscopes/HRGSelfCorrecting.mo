within HRG.Gyroscopes;
model HRGSelfCorrecting "Whole-angle hemispherical resonator gyro that estimates the change of its bias map and takes it out"
  extends HRGEnvelope(redeclare Controls.EstimatingController controller);
  Interfaces.Outputs.Switch mapFollowed(min = 0, max = 1, nominal = 1) "1 while the estimated change of the bias map is taken out, 0 while the channels contradict it"
    annotation (Placement(transformation(extent = {{202, -136}, {210, -128}}), iconTransformation(extent = {{100, -100}, {112, -88}})));
equation
  connect(controller.mapFollowed, mapFollowed)
    annotation (Line(points = {{38.2, -125}, {60, -125}, {60, -132}, {206, -132}}, color = {0, 0, 127}));
  annotation (Documentation(info="<html>
<p><code>HRGEnvelope</code> with <code>Controls.EstimatingController</code>. With the estimator's parameters at zero, their default, the outputs are the same to the bit.</p>
</html>"));
end HRGSelfCorrecting;
