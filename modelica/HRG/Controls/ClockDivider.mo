within HRG.Controls;
block ClockDivider "Every so-many-th tick of a clock"
  parameter Integer factor(min = 1) "Ticks of the clock from one tick to the next";
  input Boolean clock "Ticks that are counted";
  output Boolean tick "The first of them, and each factor-th from there";
protected
  discrete Units.DimensionlessRatio count(start = factor - 1, fixed = true) "Ticks since the last one that passed";
equation
  when clock then
    count = if pre(count) > factor - 1.5 then 0 else pre(count) + 1;
  end when;
  tick = clock and noEvent(count < 0.5);
  annotation (Documentation(info="<html>
<p>Two samples of different periods, <code>sample(0, T)</code> and <code>sample(0, 200 T)</code>, are at instants of their own: a product or a sum of floating-point
numbers may round either before the other. Counted, the slow tick is one of the fast ones. Samples of one period are at the same instants anyway.</p>
</html>"));
end ClockDivider;
