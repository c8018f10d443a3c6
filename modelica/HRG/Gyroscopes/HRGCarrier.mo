within HRG.Gyroscopes;
model HRGCarrier "Whole-angle hemispherical resonator gyro at its carrier: oscillator, converters, demodulation, electronics at 1 kHz"
  extends Interfaces.PartialGyro;
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  final parameter Units.Time converterPeriod = 5e-6 "Sample period of the converters";
  Electrodes.Ring ring "Electrodes around the shell";
  Resonators.CarrierResonator resonator(
    samplePeriod = samplePeriod,
    tick = control.tick,
    material(frequency(max = 2.5e5), ringErrors = ring.errors),
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    angularRate = angularRate,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    caseTemperature = caseTemperature,
    biasVoltage = biasVoltage,
    dampingFlicker = flicker.damping,
    vibration = vibration,
    reference = controller.reference,
    pumping = drive.pumping,
    force = drive.force) "Vibrating shell";
  Electrodes.CarrierPickOff pickOff(
    ringErrors = ring.errors,
    samplePeriod = samplePeriod,
    tick = control.tick,
    converterPeriod = converterPeriod,
    conversion = conversion,
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    position = resonator.oscillator.position,
    carrier = resonator.oscillator.carrier,
    force = controller.force,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    gradient = resonator.environment.gradient,
    rise = resonator.interpolation.rise,
    missing = resonator.interpolation.missing,
    age = resonator.environment.age,
    turning = controller.commandedTurn - (1 - controller.forceToRebalance)*resonator.material.coupling,
    biasVoltage = biasVoltage,
    gainFlicker = flicker.gain,
    phaseFlicker = flicker.phase,
    noise = noise.displacement) "Pick-offs, converters and demodulation";
  Electrodes.Drive drive(
    ringErrors = ring.errors,
    command = controller.force,
    pump = controller.pump,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    biasVoltage = biasVoltage,
    temperatureRate = resonator.environment.temperatureRate,
    noise = noise.force) "Drives";
  Noise.CoefficientFlicker flicker(
    samplePeriod = resonator.thermalPeriod,
    tick = resonator.thermalTick,
    seed = seed) "Flicker of coefficients of the shell and the pick-offs";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    tick = control.tick,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives, pick-offs and electronics";
  Controls.Controller controller(
    samplePeriod = samplePeriod,
    tick = control.tick,
    startAngle = startAngle,
    startForce = startAmplitude/resonator.material.decayTime,
    frequency = resonator.material.frequency,
    reading = pickOff.reading,
    amplitudeSetpoint = amplitudeSetpoint,
    phaseOffset = phaseOffset,
    driveOn = driveOn,
    authority = drive.authority,
    virtualRotation = virtualRotation,
    rateNoise = noise.patternRate,
    gainNoise = noise.rotation) "Control electronics";
protected
  Boolean conversion = sample(0, converterPeriod) "The one clock: each sample of the converters";
  Controls.ClockDivider control(final factor = 200, clock = conversion) "Control periods";
equation
  gyroAngle = controller.gyroAngle;
  gyroRate = controller.gyroRate;
  patternAngle = controller.patternAngle;
  amplitude = controller.detectedAmplitude;
  quadrature = controller.detectedQuadrature;
  amplitudeForce = controller.growthRate;
  quadratureForce = controller.quadratureForce;
  frequencyOffset = controller.frequencyOffset;
  valid = controller.valid;
  annotation (Documentation(info="<html>
<p>The coupled oscillators x and y of <code>Resonators.Oscillator</code>, before averaging (D. D. Lynch), and the electronics of
<code>HRGEnvelope</code> after converters and demodulation.</p>
<p>For short checks of what the envelope leaves out: the same electronics, parameters and noise as <code>HRGEnvelope</code>. While the case turns at W
the next order of the average is seen, with c = 2 k W: a quadrature force -c/(w tau), a fourth harmonic of the amplitude force, (dw/2) c/w,
and a mean modal frequency c^2/2w higher; at 100 deg/s 5e-8 rad/s, 3e-8 1/s and 1e-5 rad/s. The output is the same.</p>
</html>"));
end HRGCarrier;
