within HRG.Controls;
block Controller "Phase, amplitude and quadrature loops and the read-out; whole-angle or force-to-rebalance"
  extends PartialController;
  ProportionalIntegral phaseLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    naturalFrequency = 200,
    final startCommand(unit = "rad/s") = 0,
    error(unit = "rad") = detector.phase + phaseOffset,
    frozen = 0,
    command(unit = "rad/s"),
    integral(unit = "rad.s"))
    "Keeps the reference in phase with the antinode";
  ProportionalIntegral amplitudeLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    naturalFrequency = 6,
    startCommand = startForce,
    error = driveOn*startUp.error,
    frozen = 1 - (1 - synthesis.wasOverloaded)*(1 - startUp.isFar)) "Holds the antinode amplitude";
  ProportionalIntegral quadratureLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    naturalFrequency = 6,
    final startCommand = 0,
    error = driveOn*(quadratureSetpoint - detector.quadrature),
    frozen = synthesis.wasOverloaded) "Holds the quadrature";
  ProportionalIntegral angleLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    naturalFrequency = 100,
    final startCommand(unit = "rad/s") = 0,
    frozen = synthesis.wasOverloaded,
    error(unit = "rad") = driveOn*forceToRebalance*(startAngle + sweep.position - detector.patternAngle),
    command(unit = "rad/s"),
    integral(unit = "rad.s"))
    "Holds the pattern in the force-to-rebalance mode";
  Demodulation demodulation(
    samplePeriod = samplePeriod,
    tick = tick,
    timeDivision = timeDivision,
    reading = reading) "Filter and time division";
  DampingCancellation cancellation(cosine = detector.cosine, sine = detector.sine) "Force against damping anisotropy";
  WholeAngleReadout readout(
    samplePeriod = samplePeriod,
    tick = tick,
    final ratePeriods = 1 + timeDivision,
    patternAngle = detector.patternAngle,
    commandedAngle = commanded.angle,
    commandedRate = readout.bryanFactor*virtualRotation + angleLoop.command + sweep.rate,
    lostRate = synthesis.lostRate,
    driveOn = driveOn,
    unknownRate = cancellation.patternRate + rateNoise,
    gainNoise = gainNoise,
    angleError = scaleFactorMap.error,
    correction = biasMap.correction) "Angle of the case";
  Accumulator commanded(samplePeriod = samplePeriod, tick = tick, startAngle = startAngle, rate = readout.countedRate)
    "All rotation commanded";
  ForceSynthesis synthesis(
    samplePeriod = samplePeriod,
    tick = tick,
    parametricShare = parametricShare,
    timeDivision = timeDivision,
    driveShare = demodulation.driveShare,
    startAngle = startAngle,
    patternAngle = detector.patternAngle,
    cosine = detector.cosine,
    sine = detector.sine,
    amplitude = detector.amplitude,
    antinodeForce = amplitudeLoop.command,
    quadratureForce = quadratureLoop.command,
    patternRate = readout.patternRate,
    driveOn = driveOn,
    authority = authority) "Forces on the electrodes";
equation
  fresh = demodulation.demodulated;
  expectedAngle = 2*detector.lastAngle;
  overload = synthesis.overloaded;
  growthRate = synthesis.drivenGrowth;
  quadratureForce = synthesis.square;
  force = synthesis.force;
  pump = synthesis.pump;
  acting = synthesis.acting;
  reference = phaseLoop.command;
  commandedTurn = (1 - forceToRebalance)*(2*readout.bryanFactor*virtualRotation*driveOn) + 2*sweep.rate*driveOn;
  gyroAngle = readout.gyroAngle;
  gyroRate = readout.gyroRate;
  frequencyOffset = reference - readout.clockError*frequency;
  annotation (Documentation(info="<html>
<p>Four sampled loops on the detected orbit, as D. D. Lynch's control of the averaged equations: the phase loop turns the
reference frequency until phase + offset is zero; the amplitude loop sets the force on the antinode, A; the quadrature
loop the force on the node in quadrature, S; in the force-to-rebalance mode the angle loop commands the rotation that holds the pattern. Each is a
<code>ProportionalIntegral</code>. While a drive is at its authority, their integrals stand still, except that of the phase loop. What the drives can give
of the commanded rotation is counted and taken out of the output.</p>
</html>"));
end Controller;
