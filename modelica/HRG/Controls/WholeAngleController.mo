within HRG.Controls;
block WholeAngleController "Phase, amplitude and quadrature loops and the whole-angle read-out"
  parameter Units.Time samplePeriod(min = 1e-6) = 1e-3 "Control period";
  parameter Units.AngularFrequency phaseLoopFrequency(min = 0.1, max = 500) = 200 "Natural frequency of the phase loop";
  parameter Units.AngularFrequency amplitudeLoopFrequency(min = 0.1, max = 500) = 6 "Natural frequency of the amplitude loop";
  parameter Units.AngularFrequency quadratureLoopFrequency(min = 0.1, max = 500) = 6 "Natural frequency of the quadrature loop";
  parameter Units.Displacement amplitudeSetpoint(min = 0.01) = 1 "Antinode amplitude to hold";
  parameter Units.Time decayTime = 450 "Decay time that the amplitude loop starts from";
  parameter Units.Ratio bryanFactor(min = 0.01, max = 1) = 0.277 "Bryan factor that the electronics believe";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  input Units.Displacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.AngularRate virtualRotation "Commanded virtual rotation, as an input rate";
  output Units.Force force[4] "Commanded force {cos x, sin x, cos y, sin y}";
  output Units.AngularFrequency detuning "Reference frequency less the nominal one";
  output Units.Angle gyroAngle "Measured angle of the case since time 0";
  PatternDetector detector(samplePeriod = samplePeriod, startAngle = startAngle) "Orbit of the vibration";
  ProportionalIntegral phaseLoop(
    samplePeriod = samplePeriod,
    naturalFrequency = phaseLoopFrequency,
    startCommand(unit = "rad/s"),
    error(unit = "rad"),
    command(unit = "rad/s"),
    integral(unit = "rad.s"))
    "Keeps the reference in phase with the antinode";
  ProportionalIntegral amplitudeLoop(
    samplePeriod = samplePeriod,
    naturalFrequency = amplitudeLoopFrequency,
    startCommand = 1/decayTime) "Holds the antinode amplitude";
  ProportionalIntegral quadratureLoop(samplePeriod = samplePeriod, naturalFrequency = quadratureLoopFrequency)
    "Nulls the quadrature";
  WholeAngleReadout readout(samplePeriod = samplePeriod, startAngle = startAngle, bryanFactor = bryanFactor)
    "Angle of the case";
  ForceSynthesis synthesis(samplePeriod = samplePeriod) "Forces on the electrodes";
equation
  detector.reading = reading;
  phaseLoop.error = detector.phase;
  amplitudeLoop.error = amplitudeSetpoint - detector.amplitude;
  quadratureLoop.error = -detector.quadrature;
  readout.patternAngle = detector.patternAngle;
  readout.virtualRotation = virtualRotation;
  synthesis.cosine = detector.cosine;
  synthesis.sine = detector.sine;
  synthesis.amplitude = detector.amplitude;
  synthesis.growthRate = amplitudeLoop.command;
  synthesis.quadratureForce = quadratureLoop.command;
  synthesis.patternRate = readout.patternRate;
  force = synthesis.force;
  detuning = phaseLoop.command;
  gyroAngle = readout.gyroAngle;
end WholeAngleController;
