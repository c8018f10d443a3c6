within HRG.Validation.Environment;
model AccelerationFrame "Specific force along the axis turns the drive frame: a constant bias"
  extends BaseClasses.BiasAtRest(
    gyro(accelerationZ = acceleration, drive(rotationPerAcceleration = {0, 0, present*coefficient})));
  parameter Units.Acceleration acceleration = 9.8 "Specific force";
  parameter Real coefficient(unit = "rad.s2/m") = 1e-5 "Turn per specific force";
equation
  measured = bias.rate;
  expected = -coefficient*acceleration/(2*k*tau);
  scale = coefficient*acceleration/(2*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 6 with e = c a: mechanism 28.</p>
</html>"));
end AccelerationFrame;
