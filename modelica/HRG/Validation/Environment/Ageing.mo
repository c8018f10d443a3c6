within HRG.Validation.Environment;
model Ageing "Ageing shortens the decay time: more force for the same amplitude"
  extends BaseClasses.GrowthAtRest(gyro(resonator(material(decayTimeAgeing = present*loss))));
  parameter Units.DampingCoefficient loss = 1e-4 "Relative, per time: years in minutes";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  expected = (exp(loss*clock) - 1)/tau;
  scale = loss*clock/tau;
  annotation (experiment(StopTime = 200), Documentation(info="<html>
<p>The decay time shrinks as exp(-r t), G = exp(r t)/tau: mechanism 31.</p>
</html>"));
end Ageing;
