within HRG.Validation.Damping;
model AnisotropyBias "Damping anisotropy D: a bias of -(D/4k) sin 4(theta - theta_tau)"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
equation
  measured = bias.rate;
  expected = -anisotropy/(4*k)*sin(4*(theta - axis));
  scale = anisotropy/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(D/4k) sin 4(theta - theta_tau), whatever the rate of the case: mechanism 1.</p>
<p>The paper's Eq. (1), its axes exchanged back, its factor for physical angles, and its sign for the output instead
of the wave; D. D. Lynch, Vibratory gyro analysis by the method of averaging (1995).</p>
</html>"));
end AnisotropyBias;
