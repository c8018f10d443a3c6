within HRG.Validation.Environment;
model ThermalLag "The resonator follows a step of the case's temperature with its lag"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = lag), material(frequencyPerKelvin = present*coefficient))));
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = 85e-6 "Relative change per kelvin";
  parameter Units.Time lag = 30 "Of the resonator";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = gyro.frequencyOffset;
  expected = gyro.resonator.material.frequency*coefficient*warming*(1 - exp(-clock/lag));
  scale = gyro.resonator.material.frequency*coefficient*warming;
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>P = w c (T - T_0)(1 - exp(-t/lag)): mechanism 24.</p>
</html>"));
end ThermalLag;
