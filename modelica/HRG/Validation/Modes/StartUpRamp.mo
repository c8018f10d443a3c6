within HRG.Validation.Modes;
model StartUpRamp "Start-up: between the stages the amplitude grows on a straight line"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeDisplacement,
    tolerance = 2e-3 + 2*gyro.samplePeriod*(1 - share)/(fullTime - firstTime),
    gyro(
      startAmplitude = if present > 0 then share else 1,
      controller(startUp(firstAmplitude = if present > 0 then share else 1))));
  parameter Units.DimensionlessRatio share = 0.05 "Of the full amplitude, in the first stage";
protected
  final parameter Units.Time firstTime = gyro.controller.startUp.firstTime "t_1";
  final parameter Units.Time fullTime = gyro.controller.startUp.fullTime "t_2";
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = 1 - gyro.amplitude;
  expected = (1 - share)*(fullTime - clock)/(fullTime - firstTime);
  scale = 1;
  annotation (experiment(StopTime = 5), Documentation(info="<html>
<p>1 - a = (1 - share)(t_2 - t)/(t_2 - t_1) at t_1 &lt; t &lt; t_2, but for two samples of delay.</p>
</html>"));
end StartUpRamp;
