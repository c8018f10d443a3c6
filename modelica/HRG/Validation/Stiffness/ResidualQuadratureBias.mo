within HRG.Validation.Stiffness;
model ResidualQuadratureBias "Frequency split dw with residual quadrature q: a bias of -(dw q/2k a) cos 4(theta - theta_w)"
  extends BaseClasses.BiasAtRest(
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      resonator(material(frequencySplit = split, stiffnessAxis = axis)),
      controller(quadratureSetpoint = present*residual)));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
  parameter Units.RelativeDisplacement residual = 1e-3 "q, over the nominal amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = bias.rate;
  expected = -split*residual/(2*k*amplitude)*cos(4*(theta - axis));
  scale = split*residual/(2*k*amplitude);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(dw/2k)(q/a) cos 4(theta - theta_w): mechanism 8, 90 electrical degrees from 7; the term of Q in dth/dt of
Lynch's averaged equations, where Q = 2 a q.</p>
</html>"));
end ResidualQuadratureBias;
