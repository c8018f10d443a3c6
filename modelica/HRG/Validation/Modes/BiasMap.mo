within HRG.Validation.Modes;
model BiasMap "Compensation of the output in the dead zone: locked, the gyro still gives the rate of the case"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.AngularVelocity,
    gyro(
      angularRate = rate,
      resonator(material(dampingAnisotropy = anisotropy)),
      controller(biasMap(sin4 = -present*lockRate))));
  parameter Units.DampingCoefficient anisotropy = 1e-2 "D, of damping";
  BaseClasses.MeanRate locked(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle, begin = 1150) "Output rate";
protected
  final parameter Units.AngularVelocity lockRate = anisotropy/(4*k) "W_L";
  final parameter Units.AngularVelocity rate = 0.6*lockRate "Of the case, below lock-in";
equation
  measured = locked.rate;
  expected = rate;
  scale = rate;
  annotation (experiment(StopTime = 1200), Documentation(info="<html>
<p>The paper's Eq. (5): where the pattern stands, its bias balances the input; the map, -(D/4k) sin 4 theta, gives it
back.</p>
</html>"));
end BiasMap;
