within HRG.Controls;
block Accumulator "Integral of a rate that is held between samples"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Angle startAngle "Value at time 0";
  input Units.AngularVelocity rate "Rate, held until the next sample";
  discrete output Units.Angle angle(start = startAngle, fixed = true) "Integral up to the sample";
protected
  discrete Units.AngularVelocity held(start = 0, fixed = true) "Rate since the last sample";
equation
  when tick then
    angle = pre(angle) + samplePeriod*pre(held);
    held = rate;
  end when;
  annotation (Documentation(info="<html>
<p>angle(n) = angle(n - 1) + T rate(n - 1): exact for a rate that is held from sample to sample.</p>
</html>"));
end Accumulator;
