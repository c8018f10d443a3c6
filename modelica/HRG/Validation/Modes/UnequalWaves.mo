within HRG.Validation.Modes;
model UnequalWaves "Two travelling waves of unequal size: damping anisotropy and split couple them the more"
  extends BaseClasses.BiasAtRest(
    gyro(
      resonator(material(
        dampingAnisotropy = present*damping,
        dampingAxis = axis,
        frequencySplit = present*split,
        stiffnessAxis = stiffnessAxis)),
      controller(quadratureSetpoint = present*quadrature)));
  parameter Units.DampingCoefficient damping = 4e-6 "D";
  parameter Units.Angle axis = 0.4 "Of largest damping";
  parameter Units.AngularFrequency split = 4e-6 "dw, of frequency";
  parameter Units.Angle stiffnessAxis = 0.5 "Of the mode of lower frequency";
  parameter Units.RelativeDisplacement quadrature = 0.3 "q, half the difference of the waves' amplitudes";
protected
  final parameter Units.DimensionlessRatio ratio = (1 - quadrature)/(1 + quadrature) "Of the amplitudes";
equation
  measured = bias.rate;
  expected = -(damping/2*(ratio + 1/ratio)*sin(4*(theta - axis)) + split/2*(1/ratio - ratio)*cos(4*(theta - stiffnessAxis)))/(4*k);
  scale = (damping/2*(ratio + 1/ratio) + split/2*(1/ratio - ratio))/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The pattern is the sum of a wave of amplitude 1 + q in one sense and of 1 - q in the other; their phases differ by 4 theta, and the output is the difference of
their frequencies over 4k. With rho = (1 - q)/(1 + q):</p>
<pre>B = -(D/8k)(rho + 1/rho) sin 4(theta - theta_tau) - (dw/8k)(1/rho - rho) cos 4(theta - theta_w)</pre>
<p>Equal waves, rho = 1, are the whole-angle mode.</p>
</html>"));
end UnequalWaves;
