within HRG.Controls;
partial block PartialController "What all control electronics have: detection, start-up, compensation, read-out"
  parameter Units.Time samplePeriod "Period of the output";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Integer forceToRebalance(min = 0, max = 1) = 0 "0: whole-angle mode; 1: the pattern is held at the start angle, or where it is swept";
  parameter Units.RelativeDisplacement quadratureSetpoint(min = -0.5, max = 0.5) = 0
    "Quadrature that the loop leaves (residual), typically 1e-4 to 1e-3";
  parameter Units.DimensionlessRatio parametricShare(min = 0, max = 1) = 0
    "Share of the amplitude force that parametric drive gives, typically 0 or 1";
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.RelativeDisplacement amplitudeSetpoint "Antinode amplitude to hold";
  input Units.Angle phaseOffset "Added to the detected phase";
  input Units.DimensionlessRatio driveOn "1 with amplitude, quadrature and rotation forces on, 0 off (ring-down)";
  input Units.AngularVelocity virtualRotation "Commanded virtual rotation, as an input rate";
  input Units.AngularVelocity rateNoise "Pattern rate by slow noise of the electronics";
  input Units.DimensionlessRatio gainNoise "Relative noise of the commanded rotation";
  input Units.RelativeForce authority "A channel of the drives gives no more than this force; 0: no limit";
  output Units.DampingCoefficient growthRate "Force of the amplitude loop over detected amplitude";
  output Units.RelativeForce quadratureForce "Force of the quadrature loop";
  output Units.AngularFrequency reference "Reference frequency less the nominal one";
  output Units.AngularVelocity commandedTurn "Rate of the modal angle that virtual rotation and sweep command";
  PatternDetector detector(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    reading = reading,
    expected = expectedAngle) "Orbit of the vibration";
  StartUp startUp(
    samplePeriod = samplePeriod,
    setpoint = amplitudeSetpoint,
    amplitude = detector.amplitude,
    phase = detector.phase + phaseOffset,
    quadratureError = detector.quadrature - quadratureSetpoint,
    rebalanceError = forceToRebalance*(detector.patternAngle - (startAngle + sweep.position)),
    overload = overload) "Amplitude to aim at, and validity";
  PatternSweep sweep(samplePeriod = samplePeriod) "Mode reversal, or dither of the pattern";
  BiasMap biasMap(samplePeriod = samplePeriod, cosine = detector.cosine, sine = detector.sine) "Compensation of the output";
  ScaleFactorMap scaleFactorMap(samplePeriod = samplePeriod, cosine = detector.cosine, sine = detector.sine)
    "Compensation of the detected angle";
protected
  Units.Angle expectedAngle "Modal angle to which the detected one is nearest";
  Units.DimensionlessRatio overload "1 while a drive is at its authority";
  annotation (Documentation(info="<html>
<p>The orbit is detected from the reading, the amplitude to hold follows from the start-up, and the calibrated
bias map is integrated for the read-out, the calibrated error of the angle told to it. How forces follow from the orbit is left to who extends it.</p>
</html>"));
end PartialController;
