within HRG.Validation.BaseClasses;
partial model BiasAtRest "Output rate of a gyro at rest: its bias"
  extends Claim(redeclare type Quantity = Units.AngularRate);
  MeanRate bias(samplePeriod = gyro.samplePeriod, angle = gyro.gyroAngle) "Bias";
end BiasAtRest;
