within HRG.Validation.Stiffness;
model DuffingFrequency "Cubic stiffness: a frequency of delta a^2"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      resonator(material(duffing = present*duffing))));
  parameter Units.AngularFrequency duffing = 0.05 "delta, frequency shift at unit amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = gyro.frequencyOffset;
  expected = duffing*amplitude^2;
  scale = duffing*amplitude^2;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>P = delta a^2, here at half the amplitude: a quarter of the shift. Mechanism 14.</p>
</html>"));
end DuffingFrequency;
