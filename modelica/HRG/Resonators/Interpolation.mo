within HRG.Resonators;
block Interpolation "Straight lines between samples of temperature and gradient"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Time thermalPeriod "Sample period of temperature and gradient, a multiple of the control period";
  Boolean thermalTick = sample(0, thermalPeriod) "Each of them";
  parameter Units.TemperatureDifference startTemperature "Temperature at time 0";
  input Units.TemperatureDifference temperature "Of the resonator above the reference, sampled";
  input Units.TemperatureDifference gradient "Case above the resonator, sampled";
  discrete output Units.TemperatureDifference rise[2](each start = 0, each fixed = true) "Of temperature and gradient since the sample before";
  discrete output Units.DimensionlessRatio missing(start = 0, fixed = true) "Part of the line that is still to come";
protected
  final parameter Units.DimensionlessRatio part = samplePeriod/thermalPeriod "Part of a line that a control period takes";
  discrete Units.TemperatureDifference last[2](start = {startTemperature, 0}, each fixed = true) "Temperature and gradient at the last sample";
equation
  when thermalTick then
    rise = {temperature - pre(last[1]), gradient - pre(last[2])};
    last = {temperature, gradient};
  end when;
  when tick then
    missing = if pre(missing) > part/2 then pre(missing) - part else 1 - part;
  end when;
  annotation (Documentation(info="<html>
<p>Temperatures are sampled, since heat moves in minutes. The loops would answer each step of a pick-off's gain or phase that follows one. An amplitude force that is read
at these samples would be 4 % too large in its part by the gain's rate, and a frequency four times too large in its part by the phase's rate. From each
sample on, a line goes to the sample's value and reaches it a control period before the next: it is the sample less <code>missing*rise</code>.</p>
</html>"));
end Interpolation;
