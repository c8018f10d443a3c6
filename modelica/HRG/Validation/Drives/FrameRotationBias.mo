within HRG.Validation.Drives;
model FrameRotationBias "Drive frame turned by e: a constant bias of -e/(2k tau)"
  extends BaseClasses.BiasAtRest(gyro(drive(frameRotation = present*rotation)));
  parameter Units.Angle rotation = 1e-3 "e, on the modal axes";
equation
  measured = bias.rate;
  expected = -rotation/(2*k*tau);
  scale = rotation/(2*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -e/(2k tau): the sustaining force a/tau misses the antinode by the same angle everywhere. Mechanism 6; looks
like a true rate until the decay time changes.</p>
</html>"));
end FrameRotationBias;
