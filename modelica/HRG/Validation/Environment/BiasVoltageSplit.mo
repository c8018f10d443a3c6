within HRG.Validation.Environment;
model BiasVoltageSplit "The bias voltage splits: the quadrature force moves with V^2 - 1"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeForce,
    gyro(
      biasVoltage = voltage,
      resonator(material(electrostaticSplit = present*split, electrostaticAxis = axis))));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-2 "Trim at the nominal voltage";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
  parameter Units.DimensionlessRatio voltage = 1.01 "V, over the nominal one";
equation
  measured = gyro.quadratureForce;
  expected = split*(voltage^2 - 1)/2*sin(4*(theta - axis));
  scale = split*abs(voltage^2 - 1)/2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>As mechanism 9 with dw = split (V^2 - 1): mechanism 25.</p>
</html>"));
end BiasVoltageSplit;
