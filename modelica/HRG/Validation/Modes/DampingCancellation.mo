within HRG.Validation.Modes;
model DampingCancellation "Cancellation of damping anisotropy by force takes its bias away"
  extends BaseClasses.BiasAtRest(
    gyro(
      resonator(material(dampingAnisotropy = anisotropy, dampingAxis = axis)),
      controller(cancellation(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
equation
  measured = bias.rate + anisotropy/(4*k)*sin(4*(theta - axis));
  expected = anisotropy/(4*k)*sin(4*(theta - axis));
  scale = anisotropy/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The paper's Eq. (7), its factors mended: -(D/4) sin 4(theta - theta_tau) is driven against the damping's own. What
is measured is the share that is taken away.</p>
</html>"));
end DampingCancellation;
