within HRG.Resonators;
model Resonator "Vibrating shell, its motion as a slowly varying envelope"
  extends PartialDrivenResonator;
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
  size = abs(displacement[1]) + abs(displacement[2]) + abs(displacement[3]) + abs(displacement[4]);
  annotation (Documentation(info="<html>
<p>Material and environment give the coefficients, <code>Envelope</code> the motion.</p>
</html>"));
end Resonator;
