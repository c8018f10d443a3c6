within HRG.Validation.Damping;
model RingDownAmplitude "Ring-down: the logarithm of the amplitude falls by t/tau"
  extends BaseClasses.Claim(redeclare type Quantity = Units.DimensionlessRatio, gyro(driveOn = 1 - present));
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = log(gyro.amplitude);
  expected = -clock/tau;
  scale = clock/tau;
  annotation (experiment(StopTime = 50), Documentation(info="<html>
<p>a = a_0 exp(-t/tau). Here the drive is what is absent: without ring-down the amplitude stands.</p>
</html>"));
end RingDownAmplitude;
