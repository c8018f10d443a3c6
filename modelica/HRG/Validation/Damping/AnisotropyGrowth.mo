within HRG.Validation.Damping;
model AnisotropyGrowth "Damping anisotropy D: an amplitude force of (D/2) cos 4(theta - theta_tau)"
  extends BaseClasses.GrowthAtRest(
    gyro(resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
equation
  expected = anisotropy/2*cos(4*(theta - axis));
  scale = anisotropy/2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>G = 1/tau + (D/2) cos 4(theta - theta_tau): the amplitude loop gives back what damping takes along the antinode.
Mechanism 1; dE/dt of Lynch's averaged equations.</p>
</html>"));
end AnisotropyGrowth;
