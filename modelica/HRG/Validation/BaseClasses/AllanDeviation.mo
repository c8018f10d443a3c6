within HRG.Validation.BaseClasses;
block AllanDeviation "Allan deviation of the rate of an angle, at one averaging time"
  parameter Units.Time samplePeriod "Sample period";
  parameter Units.Time average(min = 1e-3, max = 1e4) = 0.1 "Averaging time, a multiple of the sample period";
  parameter Units.Time begin(min = 0, max = 1e6) = 5 "The record before is left out: settling";
  input Units.Angle angle "Angle";
  discrete output Units.AngularVelocity deviation(start = 0, fixed = true) "Allan deviation";
protected
  discrete Units.Time age(start = -begin - samplePeriod, fixed = true) "Time in the present mean; negative while settling";
  discrete Units.DimensionlessRatio closes(start = 0, fixed = true) "1 where a mean ends";
  discrete Units.DimensionlessRatio means(start = 0, fixed = true) "Ends so far; the first begins the record, the second ends a mean";
  discrete Units.Angle last(start = 0, fixed = true) "Angle at the last end";
  discrete Units.AngularVelocity mean(start = 0, fixed = true) "Last mean";
  discrete Real sum(unit = "rad2/s2", start = 0, fixed = true) "Of squared differences of successive means";
equation
  when sample(0, samplePeriod) then
    closes = if pre(age) + samplePeriod > (if pre(means) > 0.5 then average else 0) - samplePeriod/2 then 1 else 0;
    age = if closes > 0.5 then 0 else pre(age) + samplePeriod;
    means = pre(means) + closes;
    last = if closes > 0.5 then angle else pre(last);
    mean = if closes > 0.5 then (angle - pre(last))/average else pre(mean);
    sum = if closes > 0.5 and means > 2.5 then pre(sum) + (mean - pre(mean))*(mean - pre(mean)) else pre(sum);
    deviation = if means > 2.5 then sqrt(sum/2/(means - 2)) else 0;
  end when;
  annotation (Documentation(info="<html>
<p>The root of half the mean square of the differences of successive means (IEEE Std 952). N means give it with a
relative standard deviation of sqrt(3/4N) for white rate noise.</p>
</html>"));
end AllanDeviation;
