within HRG.Validation.Electronics;
model ClockRate "A clock fast by e: the rate is off by -e"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    gyro(angularRate = rate, controller(readout(clockError = present*excess))));
  parameter Units.AngularVelocity rate = 1 "Of the table";
  parameter Units.DimensionlessRatio excess = 1e-4 "e, of the clock";
equation
  measured = gyro.gyroRate - rate*(1 + holdError);
  expected = -excess*rate;
  scale = excess*abs(rate);
  annotation (experiment(StopTime = 5), Documentation(info="<html>
<p>Mechanism 17: a rate is counted in turns per second of the clock.</p>
</html>"));
end ClockRate;
