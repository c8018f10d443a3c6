within HRG.Controls;
block ProportionalIntegral "Critically damped loop of an integrating plant, sampled"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.AngularFrequency naturalFrequency(min = 0.01, max = 500) = 6 "Natural frequency of the closed loop";
  parameter Real startCommand(unit = "1/s") = 0 "Command that the integral gives at time 0";
  input Real error(unit = "1") "Set point less measurement";
  input Units.DimensionlessRatio frozen "1 while the integral is to wait";
  discrete output Real command(unit = "1/s", start = startCommand, fixed = true) "Command, held until the next sample";
  discrete Real integral(unit = "s", start = startCommand/naturalFrequency^2, fixed = true) "Integral of the error";
protected
  final parameter Units.DampingCoefficient proportionalGain = 2*naturalFrequency "Of the error";
  final parameter Real integralGain(unit = "1/s2") = naturalFrequency^2 "Of the integral";
equation
  when tick then
    integral = pre(integral) + samplePeriod*(1 - frozen)*error;
    command = proportionalGain*error + integralGain*integral;
  end when;
  annotation (Documentation(info="<html>
<p>Both poles of the closed loop lie at the natural frequency w: command = 2 w e + w^2 integral of e.
While the drives can't give what is commanded the integral waits, so that it doesn't wind up.
An instance whose error is an angle gives the units of its error, command and integral anew.</p>
</html>"));
end ProportionalIntegral;
