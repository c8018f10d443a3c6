within HRG.Resonators;
model Resonator "Vibrating shell, its motion as a slowly varying envelope"
  extends PartialResonator;
  Interfaces.Inputs.AngularFrequency reference "Frequency of the rotating frame above the nominal one"
    annotation (Placement(transformation(extent = {{-120, -48}, {-100, -28}})));
  Interfaces.Inputs.RelativeForce force[4] "Drive forces {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{-120, -98}, {-100, -78}})));
  Interfaces.Inputs.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them"
    annotation (Placement(transformation(extent = {{-120, -72}, {-100, -52}})));
  Interfaces.Outputs.RelativeDisplacement displacement[4] "In-phase and quadrature displacement {cx, sx, cy, sy}"
    annotation (Placement(transformation(extent = {{100, -10}, {120, 10}})));
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
