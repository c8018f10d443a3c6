within HRG.Controls;
block Demodulation "Reading as the loops have it: filtered, and only of periods in which the electrodes sense"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Time filterDelay(min = 0, max = 0.1) = 0
    "Delay of the demodulation's low-pass filter, of first order, typically 1e-4 to 2e-3 (estimate); 0: no filter";
  parameter Integer timeDivision "1: the electrodes drive in one control period and sense in the next; 0: they do both at once";
  input Units.RelativeDisplacement reading[4] "Demodulated displacement of the period before {cx, sx, cy, sy}";
  discrete output Units.RelativeDisplacement demodulated[4](each start = 0, each fixed = true) "Reading for the loops {cx, sx, cy, sy}";
  discrete output Units.DimensionlessRatio driveShare(start = 0, fixed = true) "Force until the next sample over its mean: 1; in time division 2 or 0";
protected
  final parameter Units.Time refresh = (1 + timeDivision)*samplePeriod "Time from one fresh reading to the next";
  final parameter Units.DimensionlessRatio share = refresh/(refresh + filterDelay) "Share of a change that a fresh reading shows at once";
  discrete Units.DimensionlessRatio isFresh(start = 0, fixed = true) "1 where the electrodes have sensed up to this sample";
  discrete Units.DimensionlessRatio started(start = 0, fixed = true) "1 from the first sample on";
equation
  when tick then
    isFresh = if timeDivision > 0 and pre(isFresh) > 0.5 then 0 else 1;
    demodulated = smoothed(pre(demodulated), reading, isFresh*(if pre(started) > 0.5 then share else 1));
    driveShare = isFresh*(1 + timeDivision);
    started = 1;
  end when;
  annotation (Documentation(info="<html>
<p>A filter of delay d takes T/(T + d) of each new reading, T the time between two: its delay is d, exactly so for what
changes slowly. While the case turns at W the output angle is late by d, -W d, and forces are aimed by an angle as old, as by a loop
delay: a scale-factor error of -d/tau. A virtual rotation R acts as W = -R. White noise of the reading falls to sqrt(T/(T + 2 d)), that of a mean over a second stays. A loop of natural
frequency w is stable with d below 2/w, at any T: s^2 (1 + s d) + 2 w s + w^2 = 0. For the phase loop at 200 rad/s that is 10 ms. Mechanism 39.</p>
<p>In time division the drives are off in every second period, the one that is sensed, and give twice the force in the other. A drive's
authority is then worth half. No force feeds through to a reading. The reading is that of the end of a period of decay: below the mean vibration by half a period of the force, T/2 F.
Quadrature that a split feeds therefore stands at its mean of +T/2 times its force, and the pattern drifts, as with a feedthrough of -T/2.
Every second output has a reading that is a period old. Noise of the command is that of every second sample: as one of sqrt(2) times its size. Mechanism 40.</p>
</html>"));
end Demodulation;
