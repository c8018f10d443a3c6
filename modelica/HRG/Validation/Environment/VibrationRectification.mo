within HRG.Validation.Environment;
model VibrationRectification "Random vibration closes the gaps in the mean: a gain mismatch of g_2 times spectral density times band"
  extends BaseClasses.BiasAtRest(
    gyro(
      accelerationX = acceleration,
      pickOff(
        gainPerAccelerationSquared = {present*quadratic, 0, 0},
        vibrationVariance = {density*band, 0, 0})));
  parameter Real quadratic(unit = "s4/m2") = 1e-6 "g_2";
  parameter Real density(unit = "m2/s3") = 0.4 "Spectral density of the vibration, one-sided: 4e-3 g^2/Hz";
  parameter Real band(unit = "1/s") = 1980 "20 to 2000 Hz";
  parameter Units.Acceleration acceleration = 9.8 "Specific force";
equation
  measured = bias.rate;
  expected = quadratic*(density*band + acceleration^2)/(4*k*tau)*sin(4*theta);
  scale = quadratic*(density*band + acceleration^2)/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 2 with g = g_2 (f^2 + S df): a bias that goes with the spectral density. Mechanism 36.</p>
</html>"));
end VibrationRectification;
