within HRG.Validation.Environment;
model AgeingBias "Damping anisotropy and gain mismatch age: a bias that drifts"
  extends BaseClasses.BiasAtRest(
    gyro(
      resonator(material(
        dampingAnisotropy = present*anisotropy,
        dampingAxis = axis,
        dampingAnisotropyAgeing = growth)),
      pickOff(gainAgeing = present*drift)));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, at power-on";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.DampingCoefficient growth = 1e-4 "Relative, of D per time: years in minutes";
  parameter Real drift(unit = "1/s") = 1e-6 "Of g per time";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
  Units.Time middle "Of the mean";
equation
  der(clock) = 1;
  middle = (clock + 10)/2;
  measured = bias.rate;
  expected = -anisotropy*(1 + growth*middle)/(4*k)*sin(4*(theta - axis)) + drift*(1 + middle/tau)/(4*k)*sin(4*theta);
  scale = anisotropy*(1 + growth*middle)/(4*k) + drift*(1 + middle/tau)/(4*k);
  annotation (experiment(StopTime = 110), Documentation(info="<html>
<p>As mechanisms 1 and 2 with D (1 + r t) and g = s t, which is read as the rate s/4k as well: mechanism 31.</p>
</html>"));
end AgeingBias;
