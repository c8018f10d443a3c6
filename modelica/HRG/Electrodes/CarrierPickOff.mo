within HRG.Electrodes;
block CarrierPickOff "Displacement at its carrier, converted and demodulated"
  extends PartialPickOff;
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Time converterPeriod "Sample period of the converters";
  Boolean conversion = sample(0, converterPeriod) "Each sample of the converters";
  parameter Units.RelativeDisplacement converterResolution(min = 0, max = 1) = 0 "Least significant bit of a converter, typically 2e-5 to 1e-3: 18 to 12 bits over a range of 2 (estimate); 0: none";
  parameter Units.RelativeDisplacement converterRange(min = 0, max = 1e6) = 0 "A converter clips at this value, typically 1.2 to 2, the headroom over the nominal amplitude (estimate); 0: never";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.RelativeDisplacement startAmplitude "Antinode amplitude at time 0";
  input Units.RelativeDisplacement position[2] "Displacement {x, y}";
  input Units.DimensionlessRatio carrier[2] "Cosine and sine of the reference oscillator's phase";
  Interfaces.Inputs.RelativeForce force[4] "Force in action"
    annotation (Placement(transformation(extent = {{-120, -60}, {-100, -40}})));
protected
  final parameter Units.DimensionlessRatio window = samplePeriod/converterPeriod "Samples of a control period";
  discrete Units.RelativeDisplacement y(start = 0, fixed = true) "y with the share of x";
  discrete Units.RelativeDisplacement signal[2](each start = 0, each fixed = true) "At the converters";
  Units.RelativeDisplacement received[4] "Demodulated with the phase errors {cx, sx, cy, sy}";
  discrete Units.RelativeForce lastForce[4](each start = 0, each fixed = true) "Force at the last sample";
  discrete Units.RelativeDisplacement converted[2](each start = 0, each fixed = true) "Output of the converters";
  discrete Real count(start = window - 1, fixed = true) "Samples in the window";
  discrete Real sums[17](each start = 0, each fixed = true) "Over the window, of products with the carrier (accumulated)";
  Real gathered[17] "Sums, as the control electronics read them";
  discrete Units.RelativeDisplacement demodulated[4](
    start = {startAmplitude*cos(2*startAngle), 0, startAmplitude*sin(2*startAngle), 0},
    each fixed = true) "{cx, sx, cy, sy}";
equation
  when conversion then
    y = position[2] + share*position[1];
    signal = {
      gain[1]*position[1]*(1 + cubic*position[1]^2) + feedthrough*(pre(lastForce[1])*carrier[1] + pre(lastForce[2])*carrier[2]),
      gain[2]*y*(1 + cubic*y^2) + feedthrough*(pre(lastForce[3])*carrier[1] + pre(lastForce[4])*carrier[2])};
    converted = {
      digitised(signal[1], converterResolution, converterRange),
      digitised(signal[2], converterResolution, converterRange)};
    count = if pre(count) > window - 0.5 then 1 else pre(count) + 1;
    sums = accumulated(
      pre(sums), if pre(count) > window - 0.5 then 0 else 1, count/window - 1,
      1 - cos(2*Constants.pi*(count - 0.5)/window), converted, carrier);
    lastForce = force;
  end when;
  gathered = sums;
  when tick then
    demodulated = fitted(gathered, pre(demodulated));
  end when;
  received = {
    phasor[1]*demodulated[1] + phasor[2]*demodulated[2],
    phasor[1]*demodulated[2] - phasor[2]*demodulated[1],
    phasor[3]*demodulated[3] + phasor[4]*demodulated[4],
    phasor[3]*demodulated[4] - phasor[4]*demodulated[3]};
  reading = {
    digitised(received[1] + offset + noise[1], resolution, fullScale),
    digitised(received[2] + noise[2], resolution, fullScale),
    digitised(received[3] + offsetY + noise[3], resolution, fullScale),
    digitised(received[4] + noise[4], resolution, fullScale)};
  annotation (Documentation(info="<html>
<p>The demodulation is the least-squares fit of x = cx cos P + sx sin P to a control period's samples, cx and sx linear in time: exact
for any ratio of carrier and sample rate, where a mean of products would leave a ripple of twice the carrier, and so would a
fit of constants to a pattern that turns meanwhile. A raised cosine weighs the samples, so that what is not linear leaves
next to none either. The reading is that of the moment it is read at.</p>
</html>"));
end CarrierPickOff;
