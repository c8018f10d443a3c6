within HRG.Validation.Modes;
model ParametricDrive "Parametric drive: what misaimed forces make of the bias goes as its share comes"
  extends BaseClasses.BiasAtRest(
    gyro(
      pickOff(gainMismatch = mismatch),
      drive(nonOrthogonality = skew, frameRotation = rotation),
      controller(parametricShare = present*share)));
  parameter Units.DimensionlessRatio mismatch = 1e-3 "g, of the pick-offs";
  parameter Units.DimensionlessRatio skew = 5e-4 "nd, of the drives";
  parameter Units.Angle rotation = -5e-4 "e, of the drive frame";
  parameter Units.DimensionlessRatio share = 0.75 "s";
protected
  Units.AngularVelocity misaimed "Bias by forces that electrodes give";
equation
  misaimed = (mismatch*sin(4*theta) - skew*(1 + cos(4*theta)) - 2*rotation)/(4*k*tau);
  measured = misaimed - bias.rate;
  expected = share*misaimed;
  scale = mismatch/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>A stiffness that is modulated at twice the reference frequency gives Z' = R Z*: the antinode grows by R wherever it stands, and no axis of pick-offs or
drives has a say in it. B = (1 - s)((g/4k tau) sin 4 theta - (nd/4k tau)(1 + cos 4 theta) - e/(2k tau)). What is measured is the share that is taken away.</p>
</html>"));
end ParametricDrive;
