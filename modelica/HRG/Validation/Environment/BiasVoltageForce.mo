within HRG.Validation.Environment;
model BiasVoltageForce "Pick-offs and drives gain with the bias voltage: an amplitude force of 1/(V^2 tau)"
  extends BaseClasses.GrowthAtRest(
    gyro(biasVoltage = voltage, pickOff(gainPerVoltage = present), drive(gainPerVoltage = present)));
  parameter Units.DimensionlessRatio voltage = 1.01 "V, over the nominal one";
equation
  expected = (1/voltage^2 - 1)/tau;
  scale = abs(voltage^2 - 1)/tau;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>More gain reads the same amplitude of a smaller vibration, and more gain of the drives sustains it by less command. Mechanism 25.</p>
</html>"));
end BiasVoltageForce;
