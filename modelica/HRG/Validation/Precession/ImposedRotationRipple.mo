within HRG.Validation.Precession;
model ImposedRotationRipple "Rotation imposed at V: the bias leaves an angle of D/(16 k^2 V) times the change of cos 4(theta - theta_tau)"
  extends BaseClasses.Claim(
    tolerance = 0.01,
    redeclare type Quantity = Units.Angle,
    gyro(
      virtualRotation = rotation,
      resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-3 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.AngularVelocity rotation = 0.5 "V, as an input rate";
equation
  measured = gyro.gyroAngle;
  expected = anisotropy/(16*k^2*rotation)*(cos(4*(theta - axis)) - cos(4*(startAngle - axis)));
  scale = anisotropy/(16*k^2*rotation);
  annotation (experiment(StopTime = 7), Documentation(info="<html>
<p>The integral of -(D/4k) sin 4(theta - theta_tau) over theta = theta_0 + k V t: bounded, and zero after each quarter
turn.</p>
</html>"));
end ImposedRotationRipple;
