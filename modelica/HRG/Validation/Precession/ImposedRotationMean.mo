within HRG.Validation.Precession;
model ImposedRotationMean "Rotation imposed well above lock-in: the mean bias over a full turn is zero"
  extends BaseClasses.BiasAtRest(
    tolerance = 0.01,
    gyro(
      virtualRotation = present*rotation,
      resonator(material(dampingAnisotropy = anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-3 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.Time period = 10 "In which the pattern makes a quarter turn, a period of the bias";
protected
  final parameter Units.AngularVelocity rotation = Constants.pi/(2*k*period) "V, as an input rate";
equation
  measured = expected - bias.rate;
  expected = -anisotropy/(4*k)*sin(4*(startAngle - axis));
  scale = anisotropy/(4*k);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>With theta = theta_0 + k V t the bias -(D/4k) sin 4(theta - theta_tau) averages to zero over a quarter turn, to
second order: -W_L^2/(2 V). What is measured is how much of the bias at power-on is gone; without the rotation,
nothing. The paper's 1.2, where it holds; see <code>FreePrecessionAdler</code> for where it does not.</p>
</html>"));
end ImposedRotationMean;
