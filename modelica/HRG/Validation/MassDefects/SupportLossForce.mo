within HRG.Validation.MassDefects;
model SupportLossForce "A first harmonic of the mass alone: decay time, and no anisotropy"
  extends BaseClasses.GrowthAtRest(
    gyro(resonator(massDefects(first = present*first, firstAxis = 0.4, lateralLoss = lateral))));
  parameter Units.DimensionlessRatio first = 5e-3 "m1";
  parameter Units.DampingCoefficient lateral = 20 "Loss by a sway";
equation
  expected = lateral*(0.75*first)^2;
  scale = lateral*(0.75*first)^2;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>G = 1/tau + (9/16) lateralLoss m1^2, at every pattern angle: the sway has one size, whatever its direction. Mechanism 35.</p>
</html>"));
end SupportLossForce;
