within HRG.Controls;
block QuasisteadyController "Control electronics whose loops follow at once"
  extends PartialController;
  input Real freeRates[4] "Rates of the displacement without drive, {cx, sx, cy, sy}";
  input Units.RelativeDisplacement amplitude "True antinode amplitude";
  input Units.RelativeDisplacement quadrature "True quadrature";
  input Units.Angle phase "True phase against the reference";
  input Units.Angle modalAngle "True modal angle";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.AngularVelocity coupling "Bryan coupling of the modes";
  input Units.RelativeDisplacement analogue[4] "Reading before noise and conversion";
  input Units.DimensionlessRatio driveGain[4] "Drives' force over command";
  input Units.DimensionlessRatio pumpGain[3] "Growth by parametric drive over command, of x, of y and between them";
  output Real rates[4] "Derivatives of modal angle, amplitude, quadrature and phase";
  QuasisteadyLoops synthesis(
    samplePeriod = samplePeriod,
    tick = tick,
    freeRates = freeRates,
    amplitude = amplitude,
    quadrature = quadrature,
    phase = phase,
    modalAngle = modalAngle,
    axes = axes,
    coupling = coupling,
    analogue = demodulation.settled,
    driveGain = driveGain,
    pumpGain = pumpGain,
    parametricShare = parametricShare,
    timeDivision = timeDivision,
    authority = authority/(1 + timeDivision),
    driveOn = driveOn,
    amplitudeAim = startUp.aim,
    amplitudeRate = startUp.aimRate,
    quadratureAim = quadratureSetpoint,
    phaseAim = -phaseOffset,
    modalAim = 2*(startAngle + swept),
    sweepRate = sweep.rate,
    rebalance = forceToRebalance,
    patternRate = readout.patternRate) "Loops and forces";
  QuasisteadyDemodulation demodulation(
    reading = reading,
    analogue = analogue,
    turning = commandedTurn - (1 - forceToRebalance)*coupling) "Filter";
  DampingCancellation cancellation(cosine = synthesis.detection[4], sine = synthesis.detection[5])
    "Force against damping anisotropy";
  WholeAngleReadout readout(
    samplePeriod = samplePeriod,
    tick = tick,
    final ratePeriods = 1,
    patternAngle = detector.patternAngle,
    commandedAngle = commanded,
    commandedRate = readout.bryanFactor*virtualRotation + sweep.rate,
    lostRate = synthesis.lostRate,
    driveOn = driveOn,
    unknownRate = cancellation.patternRate + rateNoise,
    gainNoise = gainNoise,
    angleError = scaleFactorMap.error,
    correction = biasMap.correction) "Angle of the case";
protected
  Units.Angle commanded(start = startAngle, fixed = true) "Pattern angle at time 0 and all rotation counted since";
  Units.Angle swept(start = 0, fixed = true) "Position of the sweep";
  Units.DimensionlessRatio countedShare "Share of a rotation that is counted under the noise of its gain";
  Units.AngularVelocity counted "Rotation that is counted in the force-to-rebalance mode";
equation
  fresh = demodulation.demodulated;
  expectedAngle = modalAngle;
  overload = 0;
  countedShare = 1 - gainNoise/(1 + readout.virtualRotationError);
  counted = driveOn*(synthesis.drivenRate - readout.unknownRate)*countedShare/(1 + readout.virtualRotationError);
  der(commanded) = readout.countedRate + forceToRebalance*((1 + readout.clockError)*counted - readout.countedRate);
  der(swept) = sweep.rate;
  rates = {synthesis.motion[1], synthesis.motion[2], synthesis.motion[3], synthesis.motion[4]};
  force = synthesis.force;
  acting = synthesis.force;
  pump = parametricShare*growthRate;
  growthRate = synthesis.growthRate;
  quadratureForce = synthesis.quadratureForce;
  reference = synthesis.reference;
  commandedTurn = (1 - forceToRebalance)*(2*readout.bryanFactor*virtualRotation*driveOn) + 2*sweep.rate*driveOn;
  gyroAngle = readout.gyroAngle;
  gyroRate = readout.gyroRate;
  frequencyOffset = reference - readout.clockError*frequency;
  annotation (Documentation(info="<html>
<p>The parts of <code>Controller</code> around <code>QuasisteadyLoops</code>: forces are those that hold amplitude, quadrature and phase,
and the rotation that they command is counted continuously. In the force-to-rebalance mode the counted rotation is the one that
holds the pattern, less what is driven uncounted.</p>
</html>"));
end QuasisteadyController;
