within HRG.Validation.Stiffness;
model ElectrostaticCubicFrequency "Cubic softening of eight electrodes: a frequency of -delta a^2 (3/4 + cos 8 theta/4)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      resonator(material(electrostaticCubic = present*cubic))));
  parameter Units.AngularFrequency cubic = 0.02 "delta, at unit amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.8 "a";
equation
  measured = gyro.frequencyOffset;
  expected = -cubic*amplitude^2*(0.75 + cos(8*theta)/4);
  scale = cubic*amplitude^2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>delta a^2 (cos^4 2 theta + sin^4 2 theta). The mean acts as Duffing stiffness does, mechanism 14. Mechanism 33.</p>
</html>"));
end ElectrostaticCubicFrequency;
