within HRG.Validation.Precession;
model ShiftedLockIn "Under a virtual rotation V the dead zone moves to W = V: there the output stays at V"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.005,
    gyro(
      angularRate = rate,
      virtualRotation = rotation,
      resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-2 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.AngularVelocity rotation = 0.1 "V, as an input rate";
  BaseClasses.MeanRate turning(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 1150) "Output rate";
protected
  final parameter Units.AngularVelocity excess = 0.6*anisotropy/(4*k) "Of the case over V";
  final parameter Units.AngularVelocity rate = rotation + excess "Of the case";
equation
  measured = turning.rate - rate;
  expected = -excess;
  scale = excess;
  annotation (experiment(StopTime = 1200), Documentation(info="<html>
<p>d theta/dt = k (V - W) + (D/4) sin 4(theta - theta_tau) has a rest point for |W - V| &lt; W_L: virtual rotation does not
abolish the dead zone of <code>LockInBias</code>, it moves it to where the case turns with the rotation. Mechanism 19.</p>
</html>"));
end ShiftedLockIn;
