within HRG.Validation.Modes;
model ForceToRebalance "Force-to-rebalance: the commanded rotation is the angle of the case"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.Angle,
    tolerance = 1e-6,
    gyro(angularRate = rate, controller(forceToRebalance = present)));
  parameter Units.AngularVelocity rate = 0.02 "Of the case";
protected
  Units.Angle caseAngle(start = 0, fixed = true) "Angle of the case";
equation
  der(caseAngle) = rate;
  measured = gyro.gyroAngle + (theta - startAngle)/k;
  expected = caseAngle;
  scale = abs(caseAngle);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>The pattern is held, and what turns it back is the measurement: (commanded angle)/k = W t. Without the mode nothing
is commanded, and the pattern precesses by -k W t.</p>
</html>"));
end ForceToRebalance;
