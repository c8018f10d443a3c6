within HRG.Validation.Environment;
model FrequencyOverTemperature "The modal frequency follows the temperature: a thermometer"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = 1), material(frequencyPerKelvin = present*coefficient))));
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = 85e-6 "Relative change per kelvin";
equation
  measured = gyro.frequencyOffset;
  expected = gyro.resonator.material.frequency*coefficient*warming;
  scale = gyro.resonator.material.frequency*coefficient*warming;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>P = w c (T - T_0): mechanism 23.</p>
</html>"));
end FrequencyOverTemperature;
