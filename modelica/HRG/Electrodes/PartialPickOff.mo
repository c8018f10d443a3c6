within HRG.Electrodes;
partial block PartialPickOff "Errors of pick-offs, demodulation and converters"
  parameter Units.DimensionlessRatio gainMismatch(min = -0.5, max = 0.5) = 0
    "g: x reads (1 + g/2) x, y reads (1 - g/2) y; typically 1e-3 to 1e-2 raw, 1e-5 to 1e-4 calibrated";
  parameter Units.LinearTemperatureCoefficient gainPerKelvin(min = -0.01, max = 0.01) = 0 "Change of g with temperature, typically 1e-6 to 1e-5";
  parameter Units.LinearTemperatureCoefficient gainPerGradient(min = -0.01, max = 0.01) = 0
    "Change of g with the case's temperature above the resonator's (hysteresis), typically 1e-6 to 1e-5 (estimate)";
  parameter Real gainAgeing(unit = "1/s", min = -1e-4, max = 1e-4) = 0 "Change of g with age, typically 1e-13 to 1e-11: 3e-6 to 3e-4 a year (estimate)";
  parameter Units.PerAcceleration gainPerAcceleration[3](each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of g with specific force (gap change), typically up to 1e-5";
  parameter Real gainPerAccelerationSquared[3](each unit = "s4/m2", each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of g with the square of specific force, typically 2e-8 to 5e-7: 1e-3 to 2e-2 deg/h at 1 g and a decay time of 450 s";
  parameter Real vibrationVariance[3](each unit = "m2/s4", each min = 0, each max = 1e6) = {0, 0, 0}
    "Mean square of vibration that the specific force does not show, its spectral density times the band, typically 100 to 2e4 (estimate)";
  parameter Units.DimensionlessRatio nonOrthogonality(min = -0.5, max = 0.5) = 0 "d: y reads y + d x, typically 1e-4 to 2e-3 raw";
  parameter Real cubic(unit = "1", min = -0.1, max = 0.1) = 0
    "b: x reads x (1 + 3/4 b |x|^2), typically 1e-5 to 1e-3";
  parameter Units.Angle phaseError(min = -1, max = 1) = 0
    "p: phase that the demodulation adds to both channels, typically 1e-4 to 1e-2";
  parameter Real phasePerKelvin(unit = "rad/K", min = -0.01, max = 0.01) = 0 "Change of p with temperature, typically 1e-5 to 1e-4";
  parameter Units.Angle differentialPhase(min = -1, max = 1) = 0 "x turned by +p/2, y by -p/2, typically 1e-4 to 1e-3";
  parameter Units.RelativeDisplacement offset(min = -0.1, max = 0.1) = 0 "Added to the in-phase x channel (ADC, demodulator), typically 1e-4";
  parameter Units.RelativeDisplacement offsetY(min = -0.1, max = 0.1) = 0 "Added to the in-phase y channel (ADC, demodulator), typically 1e-4";
  parameter Units.Time feedthrough(min = -0.01, max = 0.01) = 0 "Reads this time the force as well, typically 1e-6 to 1e-4";
  parameter Units.RelativeDisplacement resolution(min = 0, max = 0.1) = 0 "Least significant bit of a channel, typically 2e-7 to 6e-5: 24 to 16 bits over a full scale of 2 (estimate); 0: none";
  parameter Units.RelativeDisplacement fullScale(min = 0, max = 1e6) = 0 "A channel clips at this value, typically 1.2 to 2, the headroom over the nominal amplitude (estimate); 0: never";
  parameter Units.Time samplingSkew(min = -1e-3, max = 1e-3) = 0
    "y is sampled this time after x (one converter for both, electrodes read in turn), typically 5e-6 to 2e-4";
  parameter Units.DimensionlessRatio gainPerVoltage(min = -2, max = 2) = 0
    "Change of both gains with the bias voltage over the nominal one, typically 1 where the bias polarises the pick-offs, 0 with a carrier of their own";
  parameter Units.DimensionlessRatio ringErrors[9] "Errors of the electrode ring, as of ringErrors";
  input Units.TemperatureDifference temperature "Above the reference";
  input Units.TemperatureDifference gradient "Case above the resonator";
  input Units.TemperatureDifference rise[2] "Of temperature and gradient since the sample before";
  input Units.DimensionlessRatio missing "Part of it that is still to come";
  input Units.Time age "Time since power-on";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  input Units.AngularVelocity turning "Rate of the modal angle, as the case turns and as commanded";
  Interfaces.Inputs.DimensionlessRatio biasVoltage "Over the nominal one"
    annotation (Placement(transformation(extent = {{-120, -27}, {-100, -7}})));
  Interfaces.Inputs.DimensionlessRatio gainFlicker "Change of g by its flicker"
    annotation (Placement(transformation(extent = {{-120, 73}, {-100, 93}})));
  Interfaces.Inputs.Angle phaseFlicker "Change of p by its flicker"
    annotation (Placement(transformation(extent = {{-120, 40}, {-100, 60}})));
  Interfaces.Inputs.RelativeDisplacement noise[4] "Noise of the demodulated channels"
    annotation (Placement(transformation(extent = {{-120, -93}, {-100, -73}})));
  Interfaces.Outputs.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}"
    annotation (Placement(transformation(extent = {{100, -10}, {120, 10}})));
protected
  final parameter Units.DimensionlessRatio scale = 1 + ringErrors[1] "Mean gain";
  final parameter Units.DimensionlessRatio steadyMismatch = gainMismatch + ringErrors[2] + gainPerAccelerationSquared[1]*vibrationVariance[1]
    + gainPerAccelerationSquared[2]*vibrationVariance[2] + gainPerAccelerationSquared[3]*vibrationVariance[3]
    "g, with the ring's and what vibration rectifies";
  final parameter Units.DimensionlessRatio obliquity = nonOrthogonality + ringErrors[3] "d, that of the ring included";
  final parameter Units.DimensionlessRatio axes[4] = {
    cos(phaseError + differentialPhase/2),
    sin(phaseError + differentialPhase/2),
    cos(phaseError - differentialPhase/2),
    sin(phaseError - differentialPhase/2)} "Cosine and sine of the phase of x, and of y, at the reference temperature";
  Units.DimensionlessRatio sensitivity "Mean gain under the bias voltage";
  Units.DimensionlessRatio share "Share of x in y";
  Units.DimensionlessRatio mismatch "g under temperature and specific force";
  Units.DimensionlessRatio gain[2] "Of x and y, for small vibrations";
  Units.DimensionlessRatio turn[2] "Cosine and sine of the phase by temperature and flicker";
  Units.DimensionlessRatio sampledGain[2] "Of x and y, at the temperatures' last sample";
  Units.DimensionlessRatio gainRise "Of x since the sample before; y falls by it";
  Units.DimensionlessRatio sampledPhasor[4] "Cosine and sine of the phase of x, and of y, at the temperatures' last sample";
  Units.DimensionlessRatio phasorRise[4] "Since the sample before";
  Units.DimensionlessRatio phasor[4] "Cosine and sine of the phase of x, and of y";
equation
  share = obliquity + samplingSkew*turning;
  mismatch = steadyMismatch + gainPerKelvin*temperature + gainPerGradient*gradient + gainAgeing*age + gainFlicker
    + gainPerAcceleration[1]*acceleration[1] + gainPerAcceleration[2]*acceleration[2]
    + gainPerAcceleration[3]*acceleration[3]
    + gainPerAccelerationSquared[1]*acceleration[1]^2 + gainPerAccelerationSquared[2]*acceleration[2]^2
    + gainPerAccelerationSquared[3]*acceleration[3]^2;
  sensitivity = scale + gainPerVoltage*(biasVoltage - 1);
  sampledGain = {sensitivity*(1 + mismatch/2), sensitivity*(1 - mismatch/2)};
  gainRise = sensitivity*(gainPerKelvin*rise[1] + gainPerGradient*rise[2])/2;
  gain = {sampledGain[1] - missing*gainRise, sampledGain[2] + missing*gainRise};
  turn = {cos(phasePerKelvin*temperature + phaseFlicker), sin(phasePerKelvin*temperature + phaseFlicker)};
  sampledPhasor = {
    axes[1]*turn[1] - axes[2]*turn[2],
    axes[2]*turn[1] + axes[1]*turn[2],
    axes[3]*turn[1] - axes[4]*turn[2],
    axes[4]*turn[1] + axes[3]*turn[2]};
  phasorRise = {
    -phasePerKelvin*rise[1]*sampledPhasor[2],
    phasePerKelvin*rise[1]*sampledPhasor[1],
    -phasePerKelvin*rise[1]*sampledPhasor[4],
    phasePerKelvin*rise[1]*sampledPhasor[3]};
  phasor = {
    sampledPhasor[1] - missing*phasorRise[1],
    sampledPhasor[2] - missing*phasorRise[2],
    sampledPhasor[3] - missing*phasorRise[3],
    sampledPhasor[4] - missing*phasorRise[4]};
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Line(points = {{-20, 60}, {-20, -60}}), Line(points = {{20, 60}, {20, -60}}), Line(points = {{20, 0}, {100, 0}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>With T the temperature above the reference, f the specific force and V the bias voltage over the nominal one,</p>
<pre>g = gainMismatch + gainPerKelvin T + gainPerGradient (case's temperature - resonator's) + gainAgeing age + flicker + gainPerAcceleration f + gainPerAccelerationSquared (f^2 + vibrationVariance) (each axis by itself)
gain of x, y = m (1 + g/2), m (1 - g/2), m = 1 + gainPerVoltage (V - 1)
phase of x, y = phaseError + phasePerKelvin T + flicker + differentialPhase/2, - differentialPhase/2</pre>
<p>While the modal angle turns, a y that is sampled later has turned on by that time: y reads y + (d + samplingSkew turning) x.
The electrode ring adds its g and d, and scales both gains. Mechanisms 2, 4, 7, 10 to 13, 24, 25, 28, 30, 31, 34, 36 and 38 of the catalogue. Non-orthogonality comes first, then the cubic
nonlinearity and the gain, the phase (the complex envelope cx - i sx times exp(i p)), and offset, feedthrough, noise and
the converter.</p>
</html>"));
end PartialPickOff;
