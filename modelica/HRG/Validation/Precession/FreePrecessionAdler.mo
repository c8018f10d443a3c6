within HRG.Validation.Precession;
model FreePrecessionAdler "Free precession above lock-in: the mean bias over full turns is not zero but sqrt(W^2 - W_L^2) - W"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    gyro(angularRate = rate, resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.Time period = 400 "In which the pattern makes a quarter turn, a period of the bias";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  BaseClasses.MeanRate turning(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 10) "Output rate";
protected
  final parameter Units.DampingCoefficient anisotropy = 2*Constants.pi/(sqrt(3)*period) "D, of damping";
  final parameter Units.AngularVelocity lockRate = anisotropy/(4*k) "W_L";
  final parameter Units.AngularVelocity rate = 2*lockRate "W, of the case";
equation
  measured = turning.rate - rate;
  expected = sqrt(rate^2 - lockRate^2) - rate;
  scale = rate - sqrt(rate^2 - lockRate^2);
  annotation (experiment(StopTime = 410), Documentation(info="<html>
<p>The pattern itself is slower where its bias opposes it, and stays there longer: the full-turn mean is that of
Adler's equation. The paper's &quot;the full-turn mean is zero&quot; (1.2) fails here; it holds for an imposed
rotation, <code>ImposedRotationMean</code>. Here W = 2 W_L, and D is chosen so that a period of the bias, 2 pi/(4k
sqrt(W^2 - W_L^2)), is as stated.</p>
</html>"));
end FreePrecessionAdler;
