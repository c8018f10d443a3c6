within HRG.Validation.Environment;
model HysteresisBias "A case that warms runs ahead of the resonator: a gain mismatch that a cooling one has with the other sign"
  extends BaseClasses.BiasAtRest(
    bias(begin = 250),
    gyro(
      caseTemperature = temperature,
      resonator(environment(thermalLag = lag)),
      pickOff(gainPerGradient = present*coefficient)));
  parameter Real rise(unit = "K/s") = 1/60 "dT/dt, of the case";
  parameter Units.Time lag = 30 "Of the resonator";
  parameter Units.LinearTemperatureCoefficient coefficient = 1e-4 "g', change of the mismatch per kelvin of difference";
protected
  Units.Temperature temperature(start = 298.15, fixed = true) "Of the case";
equation
  der(temperature) = rise;
  measured = bias.rate;
  expected = coefficient*rise*lag/(4*k*tau)*sin(4*theta);
  scale = coefficient*rise*lag/(4*k*tau);
  annotation (experiment(StopTime = 300), Documentation(info="<html>
<p>On a ramp the resonator stays lag dT/dt behind: as mechanism 2 with g = g' lag dT/dt. Over a cycle of the temperature the bias is a loop. Mechanism 24.</p>
</html>"));
end HysteresisBias;
