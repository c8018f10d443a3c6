within HRG.Resonators;
model CarrierResonator "Vibrating shell at its carrier frequency"
  extends PartialResonator;
  input Units.AngularFrequency reference "Frequency of the reference oscillator above the nominal one";
  input Units.RelativeForce force[4] "Drive forces {cos x, sin x, cos y, sin y}";
  input Units.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them";
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
