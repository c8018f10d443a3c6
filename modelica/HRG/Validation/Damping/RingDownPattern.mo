within HRG.Validation.Damping;
model RingDownPattern "Ring-down: tan 2(theta - theta_tau) grows as exp(D t)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.Angle,
    gyro(resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis)), driveOn = 0));
  parameter Units.DampingCoefficient anisotropy = 5e-3 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
protected
  final parameter Units.Angle start = 2*(startAngle - axis) "Modal angle from the damping axis at power-on";
  Units.Time clock(start = 0, fixed = true) "Time";
  Units.DimensionlessRatio growth "Of the tangent";
equation
  der(clock) = 1;
  growth = exp(anisotropy*clock);
  measured = theta - startAngle;
  expected = atan2((growth - 1)*sin(start)*cos(start), cos(start)^2 + growth*sin(start)^2)/2;
  scale = anisotropy*clock/4;
  annotation (experiment(StopTime = 200), Documentation(info="<html>
<p>tan 2(theta - theta_tau) = tan 2(theta_0 - theta_tau) exp(D t): with no drive, x and y of the damping axes decay
each by its own law.</p>
<p>By the addition theorem the angle travelled is (1/2) atan[(g - 1) s c/(c^2 + g s^2)], g = exp(D t), s and c of
2(theta_0 - theta_tau), which has no pole. The one test that tells damping anisotropy from misaimed forces.</p>
</html>"));
end RingDownPattern;
