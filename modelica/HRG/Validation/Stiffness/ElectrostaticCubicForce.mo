within HRG.Validation.Stiffness;
model ElectrostaticCubicForce "Cubic softening of eight electrodes: a quadrature force of (delta/4) a^3 sin 8 theta"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeForce,
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      biasVoltage = voltage,
      resonator(material(electrostaticCubic = present*cubic))));
  parameter Units.AngularFrequency cubic = 0.02 "delta, at unit amplitude and nominal voltage";
  parameter Units.RelativeDisplacement amplitude = 0.8 "a";
  parameter Units.DimensionlessRatio voltage = 1.1 "V, over the nominal one";
equation
  measured = gyro.quadratureForce;
  expected = cubic*voltage^2*amplitude*amplitude^2/4*sin(8*theta);
  scale = cubic*voltage^2*amplitude*amplitude^2/4;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>X' = -i delta V^2 |X|^2 X and Y' alike: between the electrodes a pattern of amplitude a is turned into quadrature as by a split of
(delta/2) V^2 a^2 sin 8 theta. Mechanism 33.</p>
</html>"));
end ElectrostaticCubicForce;
