within HRG.Validation.Drives;
model NonOrthogonalityBias "Drive non-orthogonality: a bias of -(d/4k tau)(1 + cos 4 theta), whose mean is not zero"
  extends BaseClasses.BiasAtRest(gyro(drive(nonOrthogonality = present*skew)));
  parameter Units.DimensionlessRatio skew = 1e-3 "d";
equation
  measured = bias.rate;
  expected = -skew/(4*k*tau)*(1 + cos(4*theta));
  scale = skew/(4*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(d/4k tau)(1 + cos 4 theta): the force that sustains the amplitude misses the antinode. Mechanism 5.</p>
</html>"));
end NonOrthogonalityBias;
