within HRG.Validation.BaseClasses;
partial model BiasAtRest "Output rate of a gyro at rest: its bias"
  extends Claim(redeclare type Quantity = Units.AngularVelocity);
  MeanRate bias(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle) "Bias";
  annotation (Documentation(info="<html>
<p>At rest the output is bias alone, since the Earth does not turn here.</p>
</html>"));
end BiasAtRest;
