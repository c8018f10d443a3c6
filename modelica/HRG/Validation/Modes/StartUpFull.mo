within HRG.Validation.Modes;
model StartUpFull "Start-up: the full amplitude is there at 10 s"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeDisplacement,
    tolerance = 0.01,
    gyro(
      startAmplitude = share,
      amplitudeSetpoint = if present > 0 then 1 else share,
      controller(startUp(firstAmplitude = if present > 0 then share else 1))));
  parameter Units.DimensionlessRatio share = 0.05 "Of the full amplitude, in the first stage";
equation
  measured = gyro.amplitude - share;
  expected = 1 - share;
  scale = 1;
  annotation (experiment(StopTime = 10.5), Documentation(info="<html>
<p>The end of the second stage. What is measured is the growth since power-on; with a set point as small as the first
stage there is none.</p>
</html>"));
end StartUpFull;
