within HRG.Validation.BaseClasses;
partial model Turning "Angle read on a table that turns at a constant rate"
  extends Claim(redeclare type Quantity = Units.Angle, gyro(angularRate = rate));
  parameter Units.AngularVelocity rate = 1 "Rate of the table";
protected
  Units.Angle caseAngle(start = 0, fixed = true) "Angle of the table";
  Units.Angle angleError "Error of the gyro's angle, the hold's taken out";
equation
  der(caseAngle) = rate;
  angleError = gyro.gyroAngle - (1 + holdError)*caseAngle;
  annotation (Documentation(info="<html>
<p>The table's angle is the integral of its rate; a claim compares the output angle with it.</p>
</html>"));
end Turning;
