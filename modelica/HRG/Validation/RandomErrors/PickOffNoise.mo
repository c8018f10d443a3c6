within HRG.Validation.RandomErrors;
model PickOffNoise "Pick-off noise: Allan deviation sqrt(3) s/T, s = S/sqrt(Ts)/(2k a) in angle"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.08,
    gyro(
      seed = 1,
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      noise(pickOff = present*density)));
  parameter Units.NoiseDensity density = 1e-8 "S, of a channel";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
  parameter Units.Time average = 0.05 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = density*sqrt(3/controlPeriod)/(2*k*amplitude*average);
  scale = density*sqrt(3/controlPeriod)/(2*k*amplitude*average);
  annotation (experiment(StopTime = 105), Documentation(info="<html>
<p>White angle noise: successive means of the rate share a sample, hence 3 s^2/T^2. A channel of noise S
at period Ts reads with a deviation of S/sqrt(Ts), the angle with 1/(2k a) of it. Mechanism 21. 2000 means, correlated:
3.5 standard deviations are 0.08.</p>
</html>"));
end PickOffNoise;
