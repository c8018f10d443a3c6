within HRG.Resonators;
block Environment "Temperature of the resonator, rate of the case's temperature, and age, sampled"
  parameter Units.Time samplePeriod "Sample period";
  Boolean tick = sample(0, samplePeriod) "Each sample period";
  parameter Units.Temperature referenceTemperature(min = 1, max = 1000) = 298.15 "Temperature that parameters hold at";
  parameter Units.Time thermalLag(min = 1, max = 1e6) = 600 "Lag of the resonator behind the case, typically 60 to 1800 s";
  parameter Units.TemperatureDifference startTemperature(min = -400, max = 400) = 0
    "Resonator above the reference temperature at power-on, after a soak, typically -65 to 45: -40 to 70 degC";
  parameter Units.TemperatureDifference selfHeating(min = 0, max = 100) = 0
    "Rise of the resonator above the case by the electronics' power, once steady, typically 0.5 to 10";
  input Units.Temperature caseTemperature "Temperature of the case";
  discrete output Units.TemperatureDifference temperature(start = startTemperature, fixed = true)
    "Resonator above the reference temperature";
  discrete output Real temperatureRate(unit = "K/s", start = 0, fixed = true) "Rate of the case's temperature";
  discrete output Units.TemperatureDifference gradient(start = 0, fixed = true) "Case above the resonator, while it warms or cools";
  discrete output Units.Time age(start = 0, fixed = true) "Time since power-on";
protected
  final parameter Units.DimensionlessRatio approach = 1 - exp(-samplePeriod/thermalLag) "Share of the difference that a period takes away";
  discrete Units.TemperatureDifference case(start = 0, fixed = true) "Case above the reference temperature";
  discrete Units.DimensionlessRatio started(start = 0, fixed = true) "1 from the first sample on";
equation
  when tick then
    case = caseTemperature - referenceTemperature;
    temperature = pre(temperature) + pre(started)*approach*(case + selfHeating - pre(temperature));
    gradient = pre(started)*(case - temperature);
    temperatureRate = pre(started)*(case - pre(case))/samplePeriod;
    age = pre(age) + samplePeriod*pre(started);
    started = 1;
  end when;
  annotation (Documentation(info="<html>
<p>The resonator starts at the reference temperature, or above or below it after a soak (<code>startTemperature</code>), and follows the case, warmed
by the electronics from power-on, with a first-order lag,</p>
<pre>thermalLag dT/dt = caseTemperature + selfHeating - T</pre>
<p>exact for a case temperature that is held from sample to sample. Heat moves in minutes, so that samples up to a second apart
are fine for it.</p>
</html>"));
end Environment;
