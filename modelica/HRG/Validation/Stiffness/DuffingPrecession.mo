within HRG.Validation.Stiffness;
model DuffingPrecession "Cubic stiffness with quadrature q: a constant bias of +delta a q/(3k)"
  extends BaseClasses.BiasAtRest(
    gyro(
      startAmplitude = amplitude,
      amplitudeSetpoint = amplitude,
      resonator(material(duffing = present*duffing)),
      controller(quadratureSetpoint = residual)));
  parameter Units.AngularFrequency duffing = 0.05 "delta, frequency shift at unit amplitude";
  parameter Units.RelativeDisplacement residual = 1e-3 "q, over the nominal amplitude";
  parameter Units.RelativeDisplacement amplitude = 0.5 "a";
equation
  measured = bias.rate;
  expected = duffing*amplitude*residual/(3*k);
  scale = duffing*amplitude*residual/(3*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = +delta a q/(3k), delta = 3 gamma/8w the frequency shift at unit amplitude: an ellipse of quadrature q precesses
by its area. Mechanism 14; the average is in <code>Resonators.Envelope</code>. The sign is that of this output, the
wave's is the other.</p>
</html>"));
end DuffingPrecession;
