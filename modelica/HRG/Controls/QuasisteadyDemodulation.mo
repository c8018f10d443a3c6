within HRG.Controls;
block QuasisteadyDemodulation "What filter and time division leave of a steady vibration's reading"
  parameter Units.Time controlPeriod "Control period of the electronics";
  parameter Units.Time filterDelay(min = 0, max = 0.1) = 0
    "Delay of the demodulation's low-pass filter, of first order, typically 1e-4 to 2e-3 (estimate); 0: no filter";
  parameter Integer timeDivision "1: the electrodes drive in one control period and sense in the next; 0: they do both at once";
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.RelativeDisplacement analogue[4] "The same before noise and conversion";
  input Units.AngularVelocity turning "Rate of the modal angle, as the case turns and as commanded";
  input Units.RelativeForce holding[4] "Mean force that holds amplitude and quadrature {cos x, sin x, cos y, sin y}";
  output Units.RelativeDisplacement demodulated[4] "Reading for the loops {cx, sx, cy, sy}";
  output Units.RelativeDisplacement settled[4] "The same before noise and conversion";
protected
  final parameter Units.Time refresh = (1 + timeDivision)*controlPeriod "Time from one fresh reading to the next";
  final parameter Units.DimensionlessRatio noiseGain = sqrt(refresh/(refresh + 2*filterDelay)) "Of white noise by the filter";
  final parameter Units.Time halfPeriod = timeDivision*controlPeriod/2 "Force times this is what the reading is below the mean";
  Units.Angle lag "Modal angle by which the filter is late";
  Units.RelativeDisplacement sag[4] "What the reading is below the mean";
  Units.RelativeDisplacement mixed[4] "Reading with as much noise as the filter leaves";
equation
  lag = filterDelay*turning;
  sag = {halfPeriod*holding[1], halfPeriod*holding[2], halfPeriod*holding[3], halfPeriod*holding[4]};
  mixed = {
    noiseGain*reading[1] + (1 - noiseGain)*analogue[1],
    noiseGain*reading[2] + (1 - noiseGain)*analogue[2],
    noiseGain*reading[3] + (1 - noiseGain)*analogue[3],
    noiseGain*reading[4] + (1 - noiseGain)*analogue[4]};
  demodulated = sensed(mixed, lag, sag);
  settled = sensed(analogue, lag, sag);
  annotation (Documentation(info="<html>
<p>The steady state of <code>Demodulation</code>, for outputs at fresh readings. Two readings that are many filter delays apart have
independent noise, smaller by sqrt(T/(T + 2 d)). Mechanisms 39 and 40.</p>
</html>"));
end QuasisteadyDemodulation;
