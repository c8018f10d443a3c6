within HRG.Validation.Environment;
model DecayTimeOverTemperature "The decay time follows the temperature: more force for the same amplitude"
  extends BaseClasses.GrowthAtRest(
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = 1), material(decayTimePerKelvin = present*coefficient))));
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = -0.003 "Relative change per kelvin";
equation
  expected = (1/(1 + coefficient*warming) - 1)/tau;
  scale = abs(coefficient*warming)/tau;
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The decay time goes as 1 + c (T - T_0): G = 1/(tau (1 + c (T - T_0))). Mechanism 24.</p>
</html>"));
end DecayTimeOverTemperature;
