within HRG.Validation.Environment;
model TemperatureRateBias "A temperature that rises at a steady rate: a bias of -(e' dT/dt)/(2k tau)"
  extends BaseClasses.BiasAtRest(
    gyro(caseTemperature = temperature, drive(rotationPerTemperatureRate = present*coefficient)));
  parameter Real rise(unit = "K/s") = 1/60 "dT/dt, of the case";
  parameter Real coefficient(unit = "rad.s/K") = 1e-2 "e', turn of the drive frame";
protected
  Units.Temperature temperature(start = 298.15, fixed = true) "Of the case";
equation
  der(temperature) = rise;
  measured = bias.rate;
  expected = -coefficient*rise/(2*k*tau);
  scale = coefficient*rise/(2*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 6 with e = e' dT/dt, the gradient that a changing temperature makes: mechanism 24.</p>
</html>"));
end TemperatureRateBias;
