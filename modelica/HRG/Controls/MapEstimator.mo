within HRG.Controls;
block MapEstimator "Change of the bias map since its calibration, estimated from the amplitude force, and its integral to take out of the output"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Real expected[23](each min = -1e4, each max = 1e4) = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}
    "Coefficients of the terms in the calibrated gyro's amplitude force";
  parameter Real sensitivity[153](each min = -1e4, each max = 1e4) = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}
    "Change of the first 17 per state, all states of a term side by side; a state is a direction of the prior with variance 1";
  parameter Units.AngularVelocity ageing[3](each min = -1, each max = 1) = {0, 0, 0}
    "Expected change of the bias map {mean, cos 4 theta, sin 4 theta}";
  parameter Units.AngularVelocity map[27](each min = -1, each max = 1) = {
    0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}
    "Change of the bias map per state, all states of a coefficient side by side; 0: nothing is corrected";
  parameter Units.DampingCoefficient noise(min = 1e-15, max = 1) = 1 "Standard deviation of the amplitude force's mean over a row";
  parameter Real temperaturePerFrequency(unit = "K.s/rad", min = -1e3, max = 1e3) = 0 "Of the resonator, by the loop frequency";
  parameter Units.TemperatureDifference splitWarmth[2](each min = -100, each max = 100) = {0, 0}
    "Temperature that the frequency split makes of the loop frequency {cos 4 theta, sin 4 theta}";
  parameter Units.Time thermalLag(min = 0, max = 1e6) = 0 "Lag of the resonator behind the case";
  parameter Units.Time settlingTime(min = 0, max = 1e4) = 20 "Rows that begin before it are left out";
  input Units.DimensionlessRatio bryanFactor "Bryan factor that the electronics believe";
  input Units.DimensionlessRatio cosine "Of the modal angle 2 theta";
  input Units.DimensionlessRatio sine "Of the modal angle 2 theta";
  input Units.DampingCoefficient growthRate "Amplitude force over detected amplitude";
  input Units.AngularFrequency frequencyOffset "Loop frequency less the nominal one";
  input Units.AngularVelocity virtualRotation "Commanded rotation of the pattern, as an input rate";
  input Units.DimensionlessRatio valid "1 while the forces are those of a free pattern whose loops have settled";
  discrete output Units.AngularVelocity change[3](each start = 0, each fixed = true)
    "Of the bias map since its calibration {mean, cos 4 theta, sin 4 theta}";
  discrete output Units.DimensionlessRatio followed(start = 1, fixed = true)
    "1 while innovations are white and the change is the estimated one; 0 while it is the expected one";
  discrete output Units.Angle correction(start = 0, fixed = true) "Integral of the change at the pattern angle, since power-on";
  ClockDivider rows(final factor = 5000, clock = tick) "Rows of 5 s";
protected
  final parameter Units.Time rowPeriod = 5000*samplePeriod "Length of a row";
  discrete Units.DimensionlessRatio c4(start = 1, fixed = true) "cos 4 theta";
  discrete Units.DimensionlessRatio s4(start = 0, fixed = true) "sin 4 theta";
  discrete Units.DimensionlessRatio c8(start = 1, fixed = true) "cos 8 theta";
  discrete Units.DimensionlessRatio s8(start = 0, fixed = true) "sin 8 theta";
  discrete Units.TemperatureDifference warmth(start = 0, fixed = true) "Temperature above the reference";
  Units.AngularVelocity held[3] "Change between rows";
  discrete Units.AngularVelocity bias(start = 0, fixed = true) "Change of the bias at the present pattern angle";
  discrete Real total[14](each start = 0, each fixed = true)
    "Sums of {force, valid, T, T^2, c4, s4, T c4, T s4, V, V^2, V c4, V s4, V c8, V s8}";
  discrete Real lastTotal[14](each start = 0, each fixed = true) "The same at the end of the last row";
  discrete Real mean[14](each start = 0, each fixed = true) "Their means over a row";
  discrete Real warming(unit = "K/s", start = 0, fixed = true) "Rate of the resonator's temperature";
  discrete Real place[4](each start = 0, each fixed = true) "{c4, s4, c8, s8} at the end of a row";
  discrete Units.Time age(start = -2*rowPeriod, fixed = true) "Begin of the row";
  discrete Units.DimensionlessRatio used(start = 0, fixed = true) "1 if the row is read";
  discrete Real case[4](each start = 0, each fixed = true) "Means over a row of W times {c4, s4, c8, s8}";
  discrete Real term[23](each start = 0, each fixed = true)
    "Means of {1, T, T^2, c4, s4, T c4, T s4, W c4, W s4, W c8, W s8, V, V c4, V s4, V c8, V s8, V T'}, and of products of two of them";
  discrete Real reading[10](each start = 0, each fixed = true) "Of a row, as of forceReading()";
  discrete Real estimate[91](each start = 0, each fixed = true) "As of kalmanUpdate()";
  discrete Real whiteness[7](each start = 0, each fixed = true) "As of whitenessTest()";
equation
  held = change;
  when tick then
    c4 = cosine*cosine - sine*sine;
    s4 = 2*cosine*sine;
    c8 = c4*c4 - s4*s4;
    s8 = 2*c4*s4;
    warmth = temperaturePerFrequency*frequencyOffset - splitWarmth[1]*c4 - splitWarmth[2]*s4;
    total = pre(total) + {growthRate, valid, warmth, warmth*warmth, c4, s4, warmth*c4, warmth*s4, virtualRotation, virtualRotation*virtualRotation,
      virtualRotation*c4, virtualRotation*s4, virtualRotation*c8, virtualRotation*s8};
    correction = pre(correction) + samplePeriod*pre(bias);
    bias = held[1] + held[2]*c4 + held[3]*s4;
  end when;
  when rows.tick then
    mean = (total - pre(lastTotal))*(samplePeriod/rowPeriod);
    warming = (mean[3] - pre(mean[3]))/rowPeriod;
    lastTotal = total;
    place = {c4, s4, c8, s8};
    case = {
      mean[11] - (place[2] - pre(place[2]))/(4*bryanFactor*rowPeriod),
      mean[12] + (place[1] - pre(place[1]))/(4*bryanFactor*rowPeriod),
      mean[13] - (place[4] - pre(place[4]))/(8*bryanFactor*rowPeriod),
      mean[14] + (place[3] - pre(place[3]))/(8*bryanFactor*rowPeriod)};
    age = pre(age) + rowPeriod;
    used = if mean[2] > 0.9999 and age > settlingTime - samplePeriod then 1 else 0;
    term = {1, mean[3], mean[4], mean[5], mean[6], mean[7], mean[8], case[1], case[2], case[3], case[4],
      mean[9], mean[11], mean[12], mean[13], mean[14], mean[9]*(warming + thermalLag*(warming - pre(warming))/rowPeriod),
      mean[10], mean[3]*case[1], mean[3]*case[2], mean[3]*mean[9], mean[3]*mean[11], mean[3]*mean[12]};
    reading = forceReading(expected, sensitivity, term, mean[1], used);
    estimate = kalmanUpdate(pre(estimate), reading, noise);
    whiteness = whitenessTest(pre(whiteness), estimate[91], used);
    followed = isWhite(whiteness);
    change = mapChange(ageing, map, estimate, followed);
  end when;
  annotation (Documentation(info="<html>
<p>Damping anisotropy and the errors of pick-offs and drives make the fourth harmonic of the amplitude force, and the bias map is its slope over the pattern angle. Where the
force is not that of the calibrated gyro, the map has changed. The force's mean over a row of 5 s is compared with a sum of terms in the temperature T, the pattern
angle theta, the case's rate W and the virtual rotation V. That W is not measured: with theta' = -k (W - V), the mean of
(W - V) cos 4 theta is the change of sin 4 theta over the row, divided by -4 k and the row's length. T' is the rate of the case's temperature, which the resonator's follows
by its lag; by its product with V shows a drive's frame that follows it. Terms of second order (V^2, T W c4, T W s4, T V, T V c4, T V s4) are
those of the calibrated gyro.</p>
<p>A Kalman filter (<code>kalmanUpdate</code>) estimates nine constant states, directions of the prior. Its innovations are tested (<code>whitenessTest</code>, <code>isWhite</code>): while they are further from white than states can make
them, the change is the expected one. Coefficients are those of one gyro, and are prepared from simulations of the calibrated one (docs/methods/witness.md). By default all are zero, and so is the
correction. Of the whole-angle mode.</p>
</html>"));
end MapEstimator;
