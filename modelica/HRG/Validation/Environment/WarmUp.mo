within HRG.Validation.Environment;
model WarmUp "After a cold soak the resonator warms up, by the case and by itself"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(resonator(
      environment(thermalLag = lag, startTemperature = soak, selfHeating = heating),
      material(frequencyPerKelvin = present*coefficient))));
  parameter Units.TemperatureDifference soak = -10 "Resonator at power-on, above the reference";
  parameter Units.TemperatureDifference heating = 2 "Rise by the electronics";
  parameter Units.LinearTemperatureCoefficient coefficient = 85e-6 "Relative change per kelvin";
  parameter Units.Time lag = 60 "Of the resonator";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = gyro.frequencyOffset;
  expected = gyro.resonator.material.frequency*coefficient*(soak*exp(-clock/lag) + heating*(1 - exp(-clock/lag)));
  scale = gyro.resonator.material.frequency*coefficient*abs(soak);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>P = w c (T_s exp(-t/lag) + T_h (1 - exp(-t/lag))) in a case at the reference temperature: mechanism 23.</p>
</html>"));
end WarmUp;
