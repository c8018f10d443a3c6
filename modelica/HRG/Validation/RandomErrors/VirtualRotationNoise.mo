within HRG.Validation.RandomErrors;
model VirtualRotationNoise "Noise of the virtual rotation V: Allan deviation V S/sqrt(T)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.08,
    gyro(seed = 1, virtualRotation = rate, noise(virtualRotation = present*density)));
  parameter Units.AngularVelocity rate = 0.17 "V, as an input rate";
  parameter Units.NoiseDensity density = 1e-4 "S, of the relative rotation";
  parameter Units.Time average = 0.1 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = rate*density/sqrt(average);
  scale = rate*density/sqrt(average);
  annotation (experiment(StopTime = 155), Documentation(info="<html>
<p>Mechanism 18: the price of virtual rotation, an angle random walk of V S. 1500 means: 3.5 standard deviations
are 0.08.</p>
</html>"));
end VirtualRotationNoise;
