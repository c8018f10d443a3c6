within HRG.Validation.RandomErrors;
model DampingFlicker "Flicker of the damping anisotropy: an Allan deviation of the bias that goes with the pattern angle"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularVelocity,
    tolerance = 0.2,
    gyro(
      seed = 1,
      resonator(material(dampingAnisotropy = anisotropy, dampingAxis = axis)),
      flicker(dampingAnisotropy = present*instability)));
  parameter Units.DampingCoefficient anisotropy = 1e-7 "D";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.DimensionlessRatio instability = 0.1 "B, relative to D";
  parameter Units.Time average = 1 "Averaging time";
  BaseClasses.AllanDeviation allan(
    samplePeriod = gyro.samplePeriod,
    angle = gyro.gyroAngle,
    average = average) "Of the output";
equation
  measured = allan.deviation;
  expected = sqrt(2*log(2)/Constants.pi)*instability*anisotropy/(4*k)*abs(sin(4*(theta - axis)));
  scale = sqrt(2*log(2)/Constants.pi)*instability*anisotropy/(4*k);
  annotation (experiment(StopTime = 405), Documentation(info="<html>
<p>0.664 B D/4k |sin 4 (theta - theta_tau)|, none along the axes: mechanism 38. The tolerance is that of <code>BiasInstability</code>.</p>
</html>"));
end DampingFlicker;
