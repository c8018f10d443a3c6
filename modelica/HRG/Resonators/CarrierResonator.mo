within HRG.Resonators;
model CarrierResonator "Vibrating shell at its carrier frequency"
  extends PartialDrivenResonator;
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
equation
  size = abs(oscillator.position[1]) + abs(oscillator.position[2]);
  annotation (Documentation(info="<html>
<p>Material and environment give the coefficients, <code>Oscillator</code> the motion.</p>
</html>"));
end CarrierResonator;
