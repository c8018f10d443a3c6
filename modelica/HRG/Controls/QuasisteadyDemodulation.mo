within HRG.Controls;
block QuasisteadyDemodulation "What the filter leaves of a steady vibration's reading"
  parameter Units.Time filterDelay(min = 0, max = 0.1) = 0
    "Delay of the demodulation's low-pass filter, of first order, typically 1e-4 to 2e-3 (estimate); 0: no filter";
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.RelativeDisplacement analogue[4] "The same before noise and conversion";
  input Units.AngularVelocity turning "Rate of the modal angle, as the case turns and as commanded";
  output Units.RelativeDisplacement demodulated[4] "Reading for the loops {cx, sx, cy, sy}";
  output Units.RelativeDisplacement settled[4] "The same before noise and conversion";
protected
  Units.Angle lag "Modal angle by which the filter is late";
  Units.DimensionlessRatio along "Response of the filter to the turning pattern, in line with it";
  Units.DimensionlessRatio across "Response a quarter of a modal turn behind";
equation
  lag = filterDelay*turning;
  along = 1/(1 + lag*lag);
  across = lag*along;
  demodulated = sensed(reading, along, across);
  settled = sensed(analogue, along, across);
  annotation (Documentation(info="<html>
<p>The steady state of <code>Demodulation</code>, for outputs at fresh readings.
The filter, 1/(1 + s d), makes of exp(i alpha) with alpha' = u/d the share 1/(1 + i u). Readings that are many filter delays apart have
independent noise, that of a mean over T + 2 d; the gyro draws it so. Mechanism 39. What time division adds (mechanism 40) is in the pick-offs' <code>forceTime</code>.</p>
</html>"));
end QuasisteadyDemodulation;
