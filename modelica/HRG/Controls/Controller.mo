within HRG.Controls;
block Controller "Phase, amplitude and quadrature loops and the read-out; whole-angle or force-to-rebalance"
  parameter Units.Time samplePeriod "Control period";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.Rate startGrowthRate "Amplitude command at time 0";
  parameter Integer forceToRebalance(min = 0, max = 1) = 0 "0: whole-angle mode; 1: the pattern is held at the start angle";
  parameter Units.Displacement quadratureSetpoint(min = -0.5, max = 0.5) = 0
    "Quadrature that the loop leaves (residual), typically 1e-4 to 1e-3";
  input Units.Displacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.Displacement amplitudeSetpoint "Antinode amplitude to hold";
  input Units.Angle phaseOffset "Added to the detected phase";
  input Units.Ratio driveOn "1 with amplitude, quadrature and rotation forces on, 0 off (ring-down)";
  input Units.AngularRate virtualRotation "Commanded virtual rotation, as an input rate";
  input Units.AngularRate rateNoise "Pattern rate by slow noise of the electronics";
  input Units.Ratio gainNoise "Relative noise of the commanded rotation";
  output Units.Force force[4] "Commanded force {cos x, sin x, cos y, sin y}";
  output Units.Force acting[4] "Force that was held up to the sample";
  output Units.AngularFrequency reference "Reference frequency less the nominal one";
  PatternDetector detector(samplePeriod = samplePeriod, startAngle = startAngle) "Orbit of the vibration";
  StartUp startUp(samplePeriod = samplePeriod) "Amplitude to aim at";
  ProportionalIntegral phaseLoop(
    samplePeriod = samplePeriod,
    naturalFrequency = 200,
    startCommand(unit = "rad/s"),
    error(unit = "rad"),
    command(unit = "rad/s"),
    integral(unit = "rad.s"))
    "Keeps the reference in phase with the antinode";
  ProportionalIntegral amplitudeLoop(samplePeriod = samplePeriod, naturalFrequency = 6, startCommand = startGrowthRate)
    "Holds the antinode amplitude";
  ProportionalIntegral quadratureLoop(samplePeriod = samplePeriod, naturalFrequency = 6) "Holds the quadrature";
  ProportionalIntegral angleLoop(
    samplePeriod = samplePeriod,
    naturalFrequency = 100,
    startCommand(unit = "rad/s"),
    error(unit = "rad"),
    command(unit = "rad/s"),
    integral(unit = "rad.s"))
    "Holds the pattern in the force-to-rebalance mode";
  DampingCancellation cancellation(samplePeriod = samplePeriod) "Force against damping anisotropy";
  BiasMap biasMap(samplePeriod = samplePeriod) "Compensation of the output";
  WholeAngleReadout readout(samplePeriod = samplePeriod, startAngle = startAngle) "Angle of the case";
  ForceSynthesis synthesis(samplePeriod = samplePeriod, startAngle = startAngle) "Forces on the electrodes";
equation
  detector.reading = reading;
  startUp.setpoint = amplitudeSetpoint;
  startUp.amplitude = detector.amplitude;
  startUp.phase = detector.phase;
  phaseLoop.error = detector.phase + phaseOffset;
  amplitudeLoop.error = driveOn*startUp.error;
  quadratureLoop.error = driveOn*(quadratureSetpoint - detector.quadrature);
  angleLoop.error = driveOn*forceToRebalance*(startAngle - detector.patternAngle);
  cancellation.cosine = detector.cosine;
  cancellation.sine = detector.sine;
  biasMap.cosine = detector.cosine;
  biasMap.sine = detector.sine;
  readout.patternAngle = detector.patternAngle;
  readout.commandedRate = driveOn*(readout.bryanFactor*virtualRotation + angleLoop.command);
  readout.unknownRate = cancellation.patternRate + rateNoise;
  readout.gainNoise = gainNoise;
  readout.correction = biasMap.correction;
  synthesis.patternAngle = detector.patternAngle;
  synthesis.cosine = detector.cosine;
  synthesis.sine = detector.sine;
  synthesis.amplitude = detector.amplitude;
  synthesis.growthRate = amplitudeLoop.command;
  synthesis.quadratureForce = quadratureLoop.command;
  synthesis.patternRate = readout.patternRate;
  synthesis.driveOn = driveOn;
  force = synthesis.force;
  acting = synthesis.acting;
  reference = phaseLoop.command;
end Controller;
