within HRG.Validation.Environment;
model AccelerationSplit "Specific force splits the frequencies"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(
      accelerationY = acceleration,
      resonator(material(splitPerAcceleration = {0, present*coefficient, 0}))));
  parameter Units.Acceleration acceleration = 9.8 "Specific force";
  parameter Real coefficient(unit = "rad.s/m") = 1e-4 "Split per specific force";
equation
  measured = gyro.frequencyOffset;
  expected = -coefficient*acceleration/2*cos(4*theta);
  scale = coefficient*acceleration/2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>As mechanism 9 with dw = c a, x being the axis of lower frequency: mechanism 28.</p>
</html>"));
end AccelerationSplit;
