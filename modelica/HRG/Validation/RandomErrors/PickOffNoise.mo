within HRG.Validation.RandomErrors;
model PickOffNoise "Pick-off noise of deviation s in angle: Allan deviation sqrt(3) s/T"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularRate,
    tolerance = 0.08,
    gyro(seed = 1, noise(pickOff = present*4*k^2*white^2*gyro.samplePeriod)));
  parameter Units.Angle white = 1e-6 "s, of the angle read at each sample";
  parameter Units.Time average = 0.05 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = sqrt(3)*white/average;
  scale = sqrt(3)*white/average;
  annotation (experiment(StopTime = 105), Documentation(info="<html>
<p>White angle noise: successive means of the rate share a sample, hence 3 s^2/T^2. Mechanism 21: a channel of density
S at period Ts reads with sqrt(S/Ts), the angle with 1/(2k) of it. 2000 means, correlated: 3.5 standard deviations are
0.08.</p>
</html>"));
end PickOffNoise;
