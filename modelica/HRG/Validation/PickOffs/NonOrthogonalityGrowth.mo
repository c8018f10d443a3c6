within HRG.Validation.PickOffs;
model NonOrthogonalityGrowth "Pick-off non-orthogonality: an amplitude force of -(d/2 tau) sin 4 theta"
  extends BaseClasses.GrowthAtRest(gyro(pickOff(nonOrthogonality = present*skew)));
  parameter Units.DimensionlessRatio skew = 1e-3 "d";
equation
  expected = -skew/(2*tau)*sin(4*theta);
  scale = skew/(2*tau);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>G = (1/tau)(1 - (d/2) sin 4 theta). Mechanism 4.</p>
</html>"));
end NonOrthogonalityGrowth;
