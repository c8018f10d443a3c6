within HRG.Controls;
partial block PartialController "What all control electronics have: detection, start-up, compensation, read-out"
  extends Interfaces.PartialElectronics;
  parameter Integer forceToRebalance(min = 0, max = 1) = 0 "0: whole-angle mode; 1: the pattern is held at the start angle, or where it is swept";
  parameter Units.RelativeDisplacement quadratureSetpoint(min = -0.5, max = 0.5) = 0
    "Quadrature that the loop leaves (residual), typically 1e-4 to 1e-3" annotation(Evaluate = false);
  parameter Units.DimensionlessRatio parametricShare(min = 0, max = 1) = 0
    "Share of the amplitude force that parametric drive gives, typically 0 or 1" annotation(Evaluate = false);
  parameter Integer timeDivision(min = 0, max = 1) = 0
    "1: the electrodes drive in one control period and sense in the next; 0: they do both at once; typically 0 or 1";
  PatternDetector detector(
    samplePeriod = samplePeriod,
    tick = tick,
    startAngle = startAngle,
    reading = fresh,
    expected = expectedAngle) "Orbit of the vibration";
  StartUp startUp(
    samplePeriod = samplePeriod,
    tick = tick,
    setpoint = amplitudeSetpoint,
    amplitude = detector.amplitude,
    phase = detector.phase + phaseOffset,
    quadratureError = detector.quadrature - quadratureSetpoint,
    rebalanceError = forceToRebalance*(detector.patternAngle - (startAngle + sweep.position)),
    overload = overload) "Amplitude to aim at, and validity";
  PatternSweep sweep(samplePeriod = samplePeriod, tick = tick) "Mode reversal, or dither of the pattern";
  BiasMap biasMap(samplePeriod = samplePeriod, tick = tick, cosine = detector.cosine, sine = detector.sine) "Compensation of the output";
  ScaleFactorMap scaleFactorMap(samplePeriod = samplePeriod, tick = tick, cosine = detector.cosine, sine = detector.sine)
    "Compensation of the detected angle";
protected
  Units.RelativeDisplacement fresh[4] "Reading behind the demodulation's filter, of periods in which the electrodes sense";
  Units.Angle expectedAngle "Modal angle to which the detected one is nearest";
  Units.DimensionlessRatio overload "1 while a drive is at its authority";
equation
  patternAngle = detector.patternAngle;
  detectedAmplitude = detector.amplitude;
  detectedQuadrature = detector.quadrature;
  valid = startUp.valid;
  isHeld = forceToRebalance;
  annotation (Documentation(info="<html>
<p>The orbit is detected from the reading behind the demodulation's filter, the amplitude to hold follows from the start-up, and the calibrated
bias map is integrated for the read-out, the calibrated error of the angle told to it. Demodulation, and how forces follow from the orbit, are left to who extends it.</p>
</html>"));
end PartialController;
