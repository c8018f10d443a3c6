within HRG.Validation.Precession;
model LockInAngle "Below lock-in the pattern stands where sin 4(theta - theta_tau) = W/W_L"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.DimensionlessRatio,
    gyro(angularRate = rate, resonator(material(dampingAnisotropy = present*anisotropy, dampingAxis = axis))));
  parameter Units.DampingCoefficient anisotropy = 1e-2 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
protected
  final parameter Units.AngularVelocity rate = 0.6*anisotropy/(4*k) "Of the case";
  Units.Angle free(start = startAngle, fixed = true) "Pattern angle without anisotropy";
equation
  der(free) = -k*rate;
  measured = sin(4*(theta - axis)) - sin(4*(free - axis));
  expected = 0.6 - sin(4*(free - axis));
  scale = 1;
  annotation (experiment(StopTime = 1200), Documentation(info="<html>
<p>The rest point of <code>LockInBias</code>. What is measured is counted from where a free pattern would be.</p>
</html>"));
end LockInAngle;
