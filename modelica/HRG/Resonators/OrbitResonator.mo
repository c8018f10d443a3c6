within HRG.Resonators;
model OrbitResonator "Vibrating shell, its motion in the elements of the orbit"
  extends PartialResonator;
  input Real rates[4] "Derivatives of modal angle, amplitude, quadrature and phase";
  output Real freeRates[4] "Rates of the displacement without drive, in a frame of the nominal frequency";
  Orbit orbit(startAngle = startAngle, startAmplitude = startAmplitude, rates = rates) "Motion";
equation
  size = orbit.amplitude;
  freeRates = envelopeRates(
    orbit.displacement, {material.dampingX, material.dampingY, material.dampingSin},
    {material.dampingX, material.dampingY, material.dampingSin}, -material.shift,
    material.splitCos, material.splitSin, material.coupling, material.duffing, material.cubic) + shake;
  annotation (Documentation(info="<html>
<p>Material and environment give the coefficients, <code>envelopeRates</code> the rates of the free displacement; what becomes of the
orbit follows from the loops, which give the rates of its elements.</p>
</html>"));
end OrbitResonator;
