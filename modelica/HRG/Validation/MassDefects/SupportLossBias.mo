within HRG.Validation.MassDefects;
model SupportLossBias "First with third harmonic of the mass, and the second: a damping anisotropy by the support"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(massDefects(
      first = present*first, firstAxis = 0.4,
      second = present*second, secondAxis = 0.9,
      third = present*third, thirdAxis = 0.2,
      lateralLoss = lateral,
      axialLoss = axial))));
  parameter Units.DimensionlessRatio first = 2e-3 "m1";
  parameter Units.DimensionlessRatio second = 1e-3 "m2";
  parameter Units.DimensionlessRatio third = 5e-4 "m3";
  parameter Units.DampingCoefficient lateral = 3 "Loss by a sway";
  parameter Units.DampingCoefficient axial = 2 "Loss by a heave";
equation
  measured = bias.rate;
  expected = -(0.75*lateral*first*third*sin(4*theta - 0.4 - 3*0.2) + axial*second^2/4*sin(4*(theta - 0.9)))/(4*k);
  scale = (0.75*lateral*first*third + axial*second^2/4)/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>As mechanism 1 with D = (3/4) lateralLoss m1 m3 about (phi_1 + 3 phi_3)/4 and (1/4) axialLoss m2^2 about phi_2, which add as vectors. Mechanism 35.</p>
</html>"));
end SupportLossBias;
