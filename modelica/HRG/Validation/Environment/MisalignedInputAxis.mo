within HRG.Validation.Environment;
model MisalignedInputAxis "An input axis tilted by delta on a turning table: Earth's rate once a turn of the table, not of the pattern"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.Angle,
    gyro(angularRate = rate + present*horizontal*sin(tilt)*sin(table)));
  parameter Units.AngularVelocity rate = 0.5 "Of the table";
  parameter Units.AngularVelocity horizontal = 5.6e-5 "Earth's rate in the table's plane";
  parameter Units.Angle tilt = 0.1 "delta, of the input axis";
protected
  Units.Angle table(start = 0, fixed = true) "Angle of the table";
equation
  der(table) = rate;
  measured = gyro.gyroAngle - table*(1 + holdError);
  expected = horizontal*sin(tilt)/rate*(1 - cos(table));
  scale = horizontal*sin(tilt)/rate;
  annotation (experiment(StopTime = 8), Documentation(info="<html>
<p>Rate W + H sin delta sin psi, psi the table's angle; its integral beyond the table's own is (H sin delta/W)(1 - cos
psi). Mechanism 29: of the mounting, so that it enters by the input. The pattern has made a quarter of 1/k less turns
by then, which tells it from damping anisotropy.</p>
</html>"));
end MisalignedInputAxis;
