within HRG.Validation.Electronics;
model ClockAngle "A clock fast by e leaves the angle alone: angle over rate is off by +e"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.DimensionlessRatio,
    gyro(angularRate = rate, controller(readout(clockError = present*excess))));
  parameter Units.AngularVelocity rate = 1 "Of the table";
  parameter Units.DimensionlessRatio excess = 1e-4 "e, of the clock";
  BaseClasses.MeanRate turning(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 5) "Angle over true time";
equation
  measured = turning.rate/rate - gyro.gyroRate/rate;
  expected = excess;
  scale = excess;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>Mechanism 17: an angle is counted in turns of the pattern, whatever the clock.</p>
</html>"));
end ClockAngle;
