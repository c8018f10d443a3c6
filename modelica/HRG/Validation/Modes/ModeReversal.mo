within HRG.Validation.Modes;
model ModeReversal "Mode reversal: antinode and node change places, and damping anisotropy its sign"
  extends BaseClasses.BiasAtRest(
    bias(begin = 2*(sweepTime + restTime)),
    gyro(
      resonator(material(dampingAnisotropy = anisotropy, dampingAxis = axis)),
      controller(
        forceToRebalance = 1,
        sweep(angle = present*Constants.pi/4, sweepTime = sweepTime, restTime = restTime))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.Time sweepTime = 5 "t_s";
  parameter Units.Time restTime = 15 "t_r";
equation
  measured = bias.rate + anisotropy/(4*k)*sin(4*(startAngle - axis));
  expected = anisotropy/(4*k)*(sin(4*(startAngle - axis))
    - 2/Constants.pi*sweepTime/(sweepTime + restTime)*cos(4*(startAngle - axis)));
  scale = anisotropy/(4*k);
  annotation (experiment(StopTime = 80), Documentation(info="<html>
<p>The pattern is held at theta_0, swept by 45 degrees within t_s, held there, and swept back: over a cycle the bias is that of the sweeps alone,
-(D/4k)(2/pi) cos 4(theta_0 - theta_tau) in their share of the time. What is measured is what is taken away.</p>
</html>"));
end ModeReversal;
