within HRG.Validation.BaseClasses;
block MeanRate "Mean rate of an angle from a time on, as the angle gained over the time passed"
  parameter Units.Time samplePeriod "Sample period";
  parameter Units.Time begin(min = 0, max = 1e6) = 10 "The angle gained before is left out: settling";
  input Units.Angle angle "Angle";
  discrete output Units.AngularVelocity rate(start = 0, fixed = true) "Mean rate since the begin";
protected
  discrete Units.Time clock(start = -samplePeriod, fixed = true) "Time";
  discrete Units.Angle first(start = 0, fixed = true) "Angle at the begin";
equation
  when sample(0, samplePeriod) then
    clock = pre(clock) + samplePeriod;
    first = if clock < begin + samplePeriod/2 then angle else pre(first);
    rate = if clock < begin + samplePeriod/2 then 0 else (angle - first)/(clock - begin);
  end when;
  annotation (Documentation(info="<html>
<p>(angle(t) - angle(begin))/(t - begin).</p>
</html>"));
end MeanRate;
