within HRG.Validation.Environment;
model PhaseOverTemperature "The demodulation phase follows the temperature, and with a frequency split the bias does"
  extends BaseClasses.BiasAtRest(
    bias(begin = 20),
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(environment(thermalLag = 1), material(frequencySplit = split)),
      pickOff(phasePerKelvin = present*coefficient)));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Real coefficient(unit = "rad/K") = 1e-4 "Change of phase per kelvin";
equation
  measured = bias.rate;
  expected = -split*coefficient*warming/(4*k)*sin(4*theta);
  scale = split*coefficient*warming/(4*k);
  annotation (experiment(StopTime = 40), Documentation(info="<html>
<p>As mechanism 7 with p = c (T - T_0): mechanism 24.</p>
</html>"));
end PhaseOverTemperature;
