within HRG.Validation.Environment;
model DampingOverTemperature "Damping anisotropy follows the temperature"
  extends BaseClasses.BiasAtRest(
    bias(begin = 20),
    gyro(
      caseTemperature = 298.15 + warming,
      resonator(
        environment(thermalLag = 1),
        material(
          dampingAnisotropy = anisotropy,
          dampingAxis = axis,
          dampingAnisotropyPerKelvin = present*coefficient))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.TemperatureDifference warming = 10 "Above the reference";
  parameter Units.LinearTemperatureCoefficient coefficient = 0.1 "Relative change per kelvin";
equation
  measured = bias.rate + anisotropy/(4*k)*sin(4*(theta - axis));
  expected = -coefficient*warming*anisotropy/(4*k)*sin(4*(theta - axis));
  scale = coefficient*warming*anisotropy/(4*k);
  annotation (experiment(StopTime = 40), Documentation(info="<html>
<p>B = -(D/4k)(1 + c (T - T_0)) sin 4(theta - theta_tau): mechanism 24. What is measured is the change.</p>
</html>"));
end DampingOverTemperature;
