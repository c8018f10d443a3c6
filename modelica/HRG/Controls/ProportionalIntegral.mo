within HRG.Controls;
block ProportionalIntegral "Critically damped loop of an integrating plant, sampled"
  parameter Units.Time samplePeriod "Control period";
  parameter Units.AngularFrequency naturalFrequency "Natural frequency of the closed loop";
  parameter Real startCommand = 0 "Command that the integral gives at time 0";
  input Real error "Set point less measurement";
  discrete output Real command(start = startCommand, fixed = true) "Command, held until the next sample";
protected
  final parameter Real proportionalGain = 2*naturalFrequency "Of the error";
  final parameter Real integralGain = naturalFrequency^2 "Of the integral";
  discrete Real integral(start = startCommand/naturalFrequency^2, fixed = true) "Integral of the error";
equation
  when sample(0, samplePeriod) then
    integral = pre(integral) + samplePeriod*error;
    command = proportionalGain*error + integralGain*integral;
  end when;
  annotation (Documentation(info="<html>
<p>Both poles of the closed loop lie at the natural frequency w: command = 2 w e + w^2 integral of e.</p>
</html>"));
end ProportionalIntegral;
