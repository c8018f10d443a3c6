within HRG.Validation.RandomErrors;
model RateRandomWalk "Rate random walk: Allan deviation K sqrt(T/3)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularRate,
    tolerance = 0.12,
    gyro(seed = 1, noise(rateRandomWalk = present*density)));
  parameter Real density(unit = "rad2/s3") = 1e-12 "K^2";
  parameter Units.Time average = 0.5 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = sqrt(density*average/3);
  scale = sqrt(density*average/3);
  annotation (experiment(StopTime = 305), Documentation(info="<html>
<p>Mechanism 22; IEEE Std 952. 600 means: 3.5 standard deviations are 0.11.</p>
</html>"));
end RateRandomWalk;
