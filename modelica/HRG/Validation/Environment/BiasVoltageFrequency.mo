within HRG.Validation.Environment;
model BiasVoltageFrequency "The bias voltage softens: the frequency moves with -(V^2 - 1) at constant temperature"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(biasVoltage = voltage, resonator(material(electrostaticShift = present*shift))));
  parameter Units.AngularFrequency shift = 2*Constants.pi*0.1 "At the nominal voltage";
  parameter Units.DimensionlessRatio voltage = 1.01 "V, over the nominal one";
equation
  measured = gyro.frequencyOffset;
  expected = -shift*(voltage^2 - 1);
  scale = shift*abs(voltage^2 - 1);
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>Electrostatic stiffness goes with the square of voltage or charge: mechanism 25.</p>
</html>"));
end BiasVoltageFrequency;
