within HRG.Resonators;
model Resonator "Vibrating shell, its motion as a slowly varying envelope"
  extends PartialResonator;
  input Units.AngularFrequency reference "Frequency of the rotating frame above the nominal one";
  input Units.RelativeForce force[4] "Drive forces {cos x, sin x, cos y, sin y}";
  input Units.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them";
  output Units.RelativeDisplacement displacement[4] "In-phase and quadrature displacement {cx, sx, cy, sy}";
  Envelope envelope(
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    dampingX = material.dampingX,
    dampingY = material.dampingY,
    dampingSin = material.dampingSin,
    shift = material.shift,
    splitCos = material.splitCos,
    splitSin = material.splitSin,
    coupling = material.coupling,
    duffing = material.duffing,
    cubic = material.cubic,
    reference = reference,
    pumping = pumping,
    force = force + shake) "Motion";
equation
  displacement = envelope.displacement;
  annotation (Documentation(info="<html>
<p>Material and environment give the coefficients, <code>Envelope</code> the motion.</p>
</html>"));
end Resonator;
