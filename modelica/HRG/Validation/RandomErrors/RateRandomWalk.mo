within HRG.Validation.RandomErrors;
model RateRandomWalk "Rate random walk: Allan deviation K sqrt(T/3)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.12,
    gyro(seed = 1, noise(rateRandomWalk = present*coefficient)));
  parameter Units.RateRandomWalk coefficient = 1e-6 "K";
  parameter Units.Time average = 0.5 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = coefficient*sqrt(average/3);
  scale = coefficient*sqrt(average/3);
  annotation (experiment(StopTime = 305), Documentation(info="<html>
<p>Mechanism 22; IEEE Std 952. 600 means: 3.5 standard deviations are 0.11.</p>
</html>"));
end RateRandomWalk;
