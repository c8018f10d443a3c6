within HRG.Validation.Environment;
model BryanFactorOverTemperature "The Bryan factor follows the temperature: a scale-factor error of c (T - T_0)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    gyro(
      angularRate = rate,
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = 1), material(bryanFactorPerKelvin = present*coefficient))));
  parameter Units.AngularVelocity rate = 1 "Of the table";
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = 1e-5 "Relative change per kelvin";
  BaseClasses.MeanRate turning(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 20) "Output rate";
equation
  measured = turning.rate - rate*(1 + holdError);
  expected = coefficient*warming*rate;
  scale = coefficient*warming*rate;
  annotation (experiment(StopTime = 40), Documentation(info="<html>
<p>As mechanism 16: mechanism 24.</p>
</html>"));
end BryanFactorOverTemperature;
