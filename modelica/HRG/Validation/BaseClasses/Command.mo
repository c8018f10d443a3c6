within HRG.Validation.BaseClasses;
block Command "A rate that changes sign at stated times"
  parameter Units.Time samplePeriod "Sample period";
  parameter Units.AngularVelocity size = 0 "Size of the rate";
  parameter Units.Time reversal(min = 1e-3, max = 1e6) = 10 "Time between changes of sign";
  discrete output Units.AngularVelocity rate(start = 0, fixed = true) "Rate";
protected
  discrete Units.Time clock(start = -samplePeriod, fixed = true) "Time since the last change";
  discrete Units.DimensionlessRatio direction(start = 1, fixed = true) "Sign";
  discrete Units.DimensionlessRatio turns(start = 0, fixed = true) "1 where the sign changes";
equation
  when sample(0, samplePeriod) then
    turns = if pre(clock) + samplePeriod > reversal - samplePeriod/2 then 1 else 0;
    clock = if turns > 0.5 then 0 else pre(clock) + samplePeriod;
    direction = if turns > 0.5 then -pre(direction) else pre(direction);
    rate = direction*size;
  end when;
  annotation (Documentation(info="<html>
<p>+<code>size</code> until <code>reversal</code>, then -<code>size</code>, and so on; it is what a reversing virtual rotation is told.</p>
</html>"));
end Command;
