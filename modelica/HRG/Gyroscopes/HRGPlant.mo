within HRG.Gyroscopes;
model HRGPlant "Resonator, pick-offs and drives of HRGEnvelope, for electronics of one's own"
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0 "Pattern angle at power-on";
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at power-on";
  input Units.AngularVelocity angularRate(start = 0, min = -100, max = 100, nominal = 0.1) "Inertial rate about the input axis";
  input Units.Acceleration accelerationX(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the x electrodes";
  input Units.Acceleration accelerationY(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force across the x electrodes";
  input Units.Acceleration accelerationZ(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the input axis";
  input Units.Temperature caseTemperature(start = 298.15, min = 100, max = 500, nominal = 300) "Temperature of the case";
  input Units.DimensionlessRatio biasVoltage(start = 1, min = 0, max = 10, nominal = 1) "Electrode bias voltage over the nominal one";
  input Units.Acceleration vibration(start = 0, min = -1e5, max = 1e5, nominal = 1) "Case vibration at the modal frequency, in phase";
  input Units.RelativeForce force[4](each start = 0, each min = -1e6, each max = 1e6, each nominal = 1e-2) "Force {cos x, sin x, cos y, sin y} that is commanded, held for a control period";
  input Units.DampingCoefficient pump(start = 0, min = -1e6, max = 1e6, nominal = 2e-3) "Growth by parametric drive that is commanded, held likewise";
  input Units.AngularFrequency reference(start = 0, min = -1e5, max = 1e5, nominal = 1) "Frequency of the reference less the nominal modal one";
  input Units.AngularVelocity commandedRate(start = 0, min = -100, max = 100, nominal = 0.1) "Rate of the modal angle that is commanded by virtual rotation and sweep";
  input Units.Switch isHeld(start = 0, min = 0, max = 1, nominal = 1) "1: the pattern is held; 0: it is free";
  output Units.RelativeDisplacement reading[4](each nominal = 1) "Demodulated displacement {cx, sx, cy, sy}, sampled with noise";
  Electrodes.Ring ring "Electrodes around the shell";
  Resonators.Resonator resonator(
    samplePeriod = samplePeriod,
    tick = tick,
    material(ringErrors = ring.errors),
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    angularRate = angularRate,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    caseTemperature = caseTemperature,
    biasVoltage = biasVoltage,
    dampingFlicker = flicker.damping,
    vibration = vibration,
    reference = reference,
    pumping = drive.pumping,
    force = drive.force) "Vibrating shell";
  Electrodes.PickOff pickOff(
    ringErrors = ring.errors,
    displacement = resonator.displacement,
    force = force,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    gradient = resonator.environment.gradient,
    rise = resonator.interpolation.rise,
    missing = resonator.interpolation.missing,
    age = resonator.environment.age,
    turning = commandedRate - (1 - isHeld)*resonator.material.coupling,
    biasVoltage = biasVoltage,
    gainFlicker = flicker.gain,
    phaseFlicker = flicker.phase,
    noise = noise.displacement) "Pick-offs and demodulation";
  Electrodes.Drive drive(
    ringErrors = ring.errors,
    command = {
      Electrodes.digitised(force[1], 0, drive.authority),
      Electrodes.digitised(force[2], 0, drive.authority),
      Electrodes.digitised(force[3], 0, drive.authority),
      Electrodes.digitised(force[4], 0, drive.authority)},
    pump = pump,
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
    tick = tick,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives and pick-offs; that of the electronics is left to them";
protected
  Boolean tick = sample(0, samplePeriod) "The one clock: each control period";
equation
  reading = pickOff.reading;
  annotation (Documentation(info="<html>
<p>The parts of <code>HRGEnvelope</code> without its controller. The exchange with the electronics is at 1 kHz: at each
multiple of 1 ms they read, and command a force and a reference frequency that hold until the next. <code>commandedRate</code> and
<code>isHeld</code> tell how the pattern turns, for pick-offs that are not sampled at once. With
<code>HRGElectronics</code> that are stepped after it in each period, it gives the bits of <code>HRGEnvelope</code>.</p>
</html>"));
end HRGPlant;
