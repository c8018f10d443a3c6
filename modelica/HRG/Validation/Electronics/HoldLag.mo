within HRG.Validation.Electronics;
model HoldLag "Forces held over a period Ts: a scale-factor error of -(Ts/2)/tau, absent in ring-down"
  extends BaseClasses.Claim(redeclare type Quantity = Units.Angle, gyro(angularRate = rate, driveOn = present));
  parameter Units.AngularVelocity rate = 1 "Of the table";
protected
  Units.Angle caseAngle(start = 0, fixed = true) "Angle of the table";
equation
  der(caseAngle) = rate;
  measured = gyro.gyroAngle - caseAngle;
  expected = -controlPeriod/2/tau*caseAngle;
  scale = controlPeriod/2/tau*caseAngle;
  annotation (experiment(StopTime = 100), Documentation(info="<html>
<p>Held forces point on average at where the pattern was Ts/2 ago, and the sustaining force 1/tau pulls it back:
mechanism 15.</p>
</html>"));
end HoldLag;
