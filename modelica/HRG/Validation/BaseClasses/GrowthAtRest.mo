within HRG.Validation.BaseClasses;
partial model GrowthAtRest "Amplitude force of a gyro at rest, beyond what mean damping takes"
  extends Claim(redeclare type Quantity = Units.DampingCoefficient);
equation
  measured = gyro.amplitudeForce - 1/tau;
  annotation (Documentation(info="<html>
<p>G - 1/tau; zero for a gyro without errors.</p>
</html>"));
end GrowthAtRest;
