within HRG.Validation.RandomErrors;
model AngleRandomWalk "Force noise: Allan deviation N/(a sqrt(T)), inverse to the amplitude"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.08,
    gyro(
      seed = 1,
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      noise(angleRandomWalk = present*coefficient)));
  parameter Units.AngleRandomWalk coefficient = 1e-6 "N, at nominal amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
  parameter Units.Time average = 0.1 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = coefficient/sqrt(average)/amplitude;
  scale = coefficient/sqrt(average)/amplitude;
  annotation (experiment(StopTime = 155), Documentation(info="<html>
<p>Mechanism 20 and the white part of 22. 1500 means: 3.5 standard deviations are 0.08.</p>
</html>"));
end AngleRandomWalk;
