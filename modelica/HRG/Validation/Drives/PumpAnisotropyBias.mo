within HRG.Validation.Drives;
model PumpAnisotropyBias "Anisotropy n of parametric drive: a bias of (n/2k tau) sin 4(theta - theta_n)"
  extends BaseClasses.BiasAtRest(
    gyro(controller(parametricShare = 1), drive(pumpAnisotropy = present*anisotropy, pumpAxis = axis)));
  parameter Units.DimensionlessRatio anisotropy = 5e-4 "n";
  parameter Units.Angle axis = 0.35 "theta_n";
equation
  measured = bias.rate;
  expected = anisotropy/(2*k*tau)*sin(4*(theta - axis));
  scale = anisotropy/(2*k*tau);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>Damping anisotropy the other way round: more growth along the axis than across it, D = -2n/tau. Mechanism 37.</p>
</html>"));
end PumpAnisotropyBias;
