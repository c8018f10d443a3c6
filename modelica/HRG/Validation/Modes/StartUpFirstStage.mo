within HRG.Validation.Modes;
model StartUpFirstStage "Start-up: within 1 s the output is valid, at a small vibration"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeDisplacement,
    tolerance = 0.01,
    gyro(
      startAmplitude = if present > 0 then 0.01 else 1,
      controller(startUp(firstAmplitude = if present > 0 then share else 1))));
  parameter Units.DimensionlessRatio share = 0.05 "Of the full amplitude, in the first stage";
equation
  measured = gyro.valid*(1 - gyro.amplitude);
  expected = 1 - share;
  scale = 1;
  annotation (experiment(StopTime = 1), Documentation(info="<html>
<p>Section 2.3 of the paper: a small vibration within 1 s, which already measures. What is measured is how far a valid
gyro's amplitude is from the full one.</p>
</html>"));
end StartUpFirstStage;
