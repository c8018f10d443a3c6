within HRG.Resonators;
model CarrierResonator "Vibrating shell at its carrier frequency"
  extends PartialResonator;
  Interfaces.Inputs.AngularFrequency reference "Frequency of the reference oscillator above the nominal one"
    annotation (Placement(transformation(extent = {{-120, -48}, {-100, -28}})));
  Interfaces.Inputs.RelativeForce force[4] "Drive forces {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{-120, -98}, {-100, -78}})));
  Interfaces.Inputs.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them"
    annotation (Placement(transformation(extent = {{-120, -72}, {-100, -52}})));
  Oscillator oscillator(
    frequency = material.frequency,
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
  annotation (Documentation(info="<html>
<p>Material and environment give the coefficients, <code>Oscillator</code> the motion.</p>
</html>"));
end CarrierResonator;
