within HRG.Validation.Modes;
model ParametricDriveLag "Parametric drive does not lag a turning pattern: no scale-factor error by hold and delay"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.Angle,
    gyro(angularRate = rate, controller(parametricShare = present, synthesis(loopDelay = delay))));
  parameter Units.AngularVelocity rate = 1 "Of the table";
  parameter Units.Time delay = 3e-3 "td";
protected
  Units.Angle caseAngle(start = 0, fixed = true) "Angle of the table";
equation
  der(caseAngle) = rate;
  measured = gyro.gyroAngle - caseAngle*(1 - (controlPeriod/2 + delay)/tau);
  expected = (controlPeriod/2 + delay)/tau*caseAngle;
  scale = (controlPeriod/2 + delay)/tau*caseAngle;
  annotation (experiment(StopTime = 100), Documentation(info="<html>
<p>Forces lag by Ts/2 + td, which pulls the pattern back by mechanism 15; the pump has no direction in which it could lag.</p>
</html>"));
end ParametricDriveLag;
