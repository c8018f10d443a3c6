within HRG.Validation.RandomErrors;
model BiasInstability "Flicker: an Allan deviation of 0.664 B, flat in the averaging time"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.2,
    gyro(seed = 1, noise(biasInstability = present*instability)));
  parameter Units.AngularVelocity instability = 1e-6 "B";
  parameter Units.Time average = 1 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = sqrt(2*log(2)/Constants.pi)*instability;
  scale = sqrt(2*log(2)/Constants.pi)*instability;
  annotation (experiment(StopTime = 405), Documentation(info="<html>
<p>sqrt(2 ln 2/pi) B = 0.664 B: mechanism 22; IEEE Std 952. A sum of lags, one an octave and a half, ripples around
it; 3.5 standard deviations of 400 means are 0.13; 0.2 in all.</p>
</html>"));
end BiasInstability;
