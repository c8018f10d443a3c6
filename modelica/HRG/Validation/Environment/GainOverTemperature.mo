within HRG.Validation.Environment;
model GainOverTemperature "Pick-off gain mismatch follows the temperature"
  extends BaseClasses.BiasAtRest(
    bias(begin = 20),
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = 1)),
      pickOff(gainPerKelvin = present*coefficient)));
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = 1e-4 "Relative change per kelvin";
equation
  measured = bias.rate;
  expected = coefficient*warming/(4*k*tau)*sin(4*theta);
  scale = coefficient*warming/(4*k*tau);
  annotation (experiment(StopTime = 40), Documentation(info="<html>
<p>As mechanism 2 with g = c (T - T_0): mechanism 24.</p>
</html>"));
end GainOverTemperature;
