within HRG.Controls;
block PatternSweep "Pattern angle by which the electronics turn the pattern to and fro"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Angle angle(min = -7, max = 7) = 0
    "Pattern angle of the far end from the first, typically 0.785398 (mode reversal: antinode and node change places) or 1.570796 (a whole period of the map); 0: none";
  parameter Units.Time sweepTime(min = 0.1, max = 1e6) = 10 "Time for one way, typically 1 to 100";
  parameter Units.Time restTime(min = 0, max = 1e6) = 0 "Time at rest at each end, typically 0 to 1000";
  discrete output Units.Angle position(start = 0, fixed = true) "Pattern angle from the first end, at the sample";
  discrete output Units.AngularVelocity rate(start = 0, fixed = true) "Pattern rate until the next sample";
protected
  final parameter Units.Time half = sweepTime + restTime "Half a cycle";
  final parameter Units.Time way = half - restTime/2 "Until the rest at the far end";
  final parameter Real sampleRate(unit = "1/s") = 1/samplePeriod "Samples a second";
  final parameter Units.AngularVelocity first = sweptAngle(angle, samplePeriod - restTime/2, sweepTime)/samplePeriod "Rate from time 0 on";
  discrete Units.Time clock(start = samplePeriod, fixed = true) "Time of the sample after the next, from the middle of the rest at the first end";
  discrete Units.AngularVelocity next(start = first, fixed = true) "Pattern rate from the next sample on";
equation
  when tick then
    position = pre(position) + samplePeriod*pre(rate);
    rate = pre(next);
    clock = if pre(clock) + 1.5*samplePeriod > 2*half then pre(clock) + samplePeriod - 2*half else pre(clock) + samplePeriod;
    next = (sweptAngle(angle, way - abs(clock - half), sweepTime) - position)*sampleRate - rate;
  end when;
  annotation (Documentation(info="<html>
<p>Rest, a sweep at a constant rate, rest at the far end, and back, beginning in the middle of the first rest. Over a whole cycle of 2 (t_s + t_r) the gyro shows the mean
of its bias over the way, weighted by time: of a fourth harmonic b at the first end, and a quarter of its period on b', with Theta = angle</p>
<pre>mean = (t_r (b(0) + b(Theta))/2 + t_s (mean of b between))/(t_s + t_r)</pre>
<p>Theta = 45 degrees is mode reversal: b(Theta) = -b(0), the sweeps leave (2/pi) b' t_s/(t_s + t_r). Theta = 90 degrees without rests is a dither of the pattern that averages
every multiple of the fourth harmonic. In the force-to-rebalance mode the pattern is held where the sweep is, in the whole-angle mode the sweep is a virtual rotation of its own; both are
counted, so that a gain error e of the rotation shows as -e times the position over k, which comes and goes.</p>
</html>"));
end PatternSweep;
