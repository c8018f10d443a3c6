within HRG.Validation.Damping;
model MountingBias "Damping of the mounting adds to that of the shell as a vector"
  extends BaseClasses.BiasAtRest(
    gyro(
      resonator(
        material(
          dampingAnisotropy = anisotropy,
          dampingAxis = axis,
          mountingDamping = present*mounting,
          mountingAxis = mountingAxis))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.DampingCoefficient mounting = 2e-6 "Damping anisotropy of the mounting";
  parameter Units.Angle mountingAxis = 0.9 "Its axis of maximum damping";
equation
  measured = bias.rate + anisotropy/(4*k)*sin(4*(theta - axis));
  expected = -mounting/(4*k)*sin(4*(theta - mountingAxis));
  scale = mounting/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(D/4k) sin 4(theta - theta_tau) - (D_m/4k) sin 4(theta - theta_m): mechanism 26. The shell's own share is
taken out of what is measured.</p>
</html>"));
end MountingBias;
