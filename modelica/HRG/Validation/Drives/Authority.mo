within HRG.Validation.Drives;
model Authority "A drive that clips at f: beyond its range the rebalanced pattern slips at k W - (f/2)(|cos 2 theta| + |sin 2 theta|)"
  extends BaseClasses.Claim(
    redeclare final model Gyro = Gyroscopes.HRGEnvelope,
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.01,
    gyro(angularRate = rate, controller(forceToRebalance = 1), drive(authority = present*authority)));
  parameter Units.RelativeForce authority = 0.02 "f, of a channel";
  parameter Units.AngularVelocity rate = 0.2 "W";
  BaseClasses.MeanRate slip(samplePeriod = gyro.samplePeriod, angle = gyro.patternAngle, begin = 1) "Rate of the pattern";
equation
  measured = slip.rate;
  expected = authority/2*(abs(cos(2*theta)) + abs(sin(2*theta))) - k*rate;
  scale = k*rate;
  annotation (experiment(StopTime = 1.1), Documentation(info="<html>
<p>A force of f on the node turns the pattern at f/2. Both channels clip once the pattern has slipped far enough, so that the
rebalancing rate is (f/2)(|cos 2 theta| + |sin 2 theta|) at most, f/2 in the worst place: full range f/(2k). Mechanism 30.</p>
</html>"));
end Authority;
