within HRG.Validation.Drives;
model PumpAnisotropyGrowth "Anisotropy n of parametric drive: an amplitude force of -(n/tau) cos 4(theta - theta_n)"
  extends BaseClasses.GrowthAtRest(
    gyro(controller(parametricShare = 1), drive(pumpAnisotropy = present*anisotropy, pumpAxis = axis)));
  parameter Units.DimensionlessRatio anisotropy = 5e-4 "n";
  parameter Units.Angle axis = 0.35 "theta_n";
equation
  expected = -anisotropy/tau*cos(4*(theta - axis));
  scale = anisotropy/tau;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>G = (1/tau)(1 - n cos 4(theta - theta_n)). Mechanism 37.</p>
</html>"));
end PumpAnisotropyGrowth;
