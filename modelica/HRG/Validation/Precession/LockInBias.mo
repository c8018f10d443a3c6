within HRG.Validation.Precession;
model LockInBias "Below lock-in, W < W_L = D/4k: the pattern stands, the output is dead"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.AngularVelocity,
    gyro(angularRate = rate, resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-2 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  BaseClasses.MeanRate turning(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 1150) "Output rate";
protected
  final parameter Units.AngularVelocity rate = 0.6*anisotropy/(4*k) "Of the case";
equation
  measured = turning.rate - rate;
  expected = -rate;
  scale = rate;
  annotation (experiment(StopTime = 1200), Documentation(info="<html>
<p>d theta/dt = -k W + (D/4) sin 4(theta - theta_tau) has a rest point for W &lt; W_L = D/4k: the bias takes all of
the input. Mechanism 19; R. Adler, A study of locking phenomena in oscillators (1946).</p>
</html>"));
end LockInBias;
