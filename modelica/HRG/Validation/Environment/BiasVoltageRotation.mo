within HRG.Validation.Environment;
model BiasVoltageRotation "Pick-offs and drives gain with the bias voltage: a virtual rotation R gives a bias of -(V^2 - 1) R"
  extends BaseClasses.BiasAtRest(
    gyro(
      biasVoltage = voltage,
      virtualRotation = rotation,
      pickOff(gainPerVoltage = present),
      drive(gainPerVoltage = present)));
  parameter Units.DimensionlessRatio voltage = 1.001 "V, over the nominal one";
  parameter Units.AngularVelocity rotation = 0.02 "R";
equation
  measured = bias.rate;
  expected = -(voltage^2 - 1)*rotation;
  scale = abs(voltage^2 - 1)*rotation;
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 18 with e = V^2 - 1: the command is scaled with the amplitude that is read, and the force with the voltage. Mechanism 25.</p>
</html>"));
end BiasVoltageRotation;
