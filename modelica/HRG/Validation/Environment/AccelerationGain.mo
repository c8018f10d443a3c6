within HRG.Validation.Environment;
model AccelerationGain "Specific force closes the gaps: a gain mismatch of g_1 a + g_2 a^2"
  extends BaseClasses.BiasAtRest(
    gyro(
      accelerationX = acceleration,
      pickOff(
        gainPerAcceleration = {present*linear, 0, 0},
        gainPerAccelerationSquared = {present*quadratic, 0, 0})));
  parameter Units.Acceleration acceleration = 9.8 "Specific force";
  parameter Units.PerAcceleration linear = 1e-5 "g_1";
  parameter Real quadratic(unit = "s4/m2") = 1e-6 "g_2";
equation
  measured = bias.rate;
  expected = (linear*acceleration + quadratic*acceleration^2)/(4*k*tau)*sin(4*theta);
  scale = (linear*acceleration + quadratic*acceleration^2)/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 2 with g = g_1 a + g_2 a^2: mechanism 28.</p>
</html>"));
end AccelerationGain;
