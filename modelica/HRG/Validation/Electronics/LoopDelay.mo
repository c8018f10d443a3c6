within HRG.Validation.Electronics;
model LoopDelay "Loop delay td: a scale-factor error of -td/tau"
  extends BaseClasses.Turning(gyro(controller(synthesis(loopDelay = present*delay))));
  parameter Units.Time delay = 3e-3 "td";
equation
  measured = angleError;
  expected = -delay/tau*caseAngle;
  scale = delay/tau*caseAngle;
  annotation (experiment(StopTime = 100), Documentation(info="<html>
<p>As the hold of <code>HoldLag</code>, with forces that are older by td: mechanism 15, odd in the rate.</p>
</html>"));
end LoopDelay;
