within HRG.Validation.BaseClasses;
partial model GrowthAtRest "Amplitude force of a gyro at rest, beyond what mean damping takes"
  extends Claim(redeclare type Quantity = Units.Rate);
equation
  measured = gyro.amplitudeForce - 1/tau;
end GrowthAtRest;
