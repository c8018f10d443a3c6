within HRG.Gyroscopes;
model HRG "Whole-angle hemispherical resonator gyro: complex envelope, electronics sampled at 1 kHz"
  extends Interfaces.PartialGyro;
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  Resonators.Resonator resonator(
    final thermalPeriod = 1e-2,
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    angularRate = angularRate,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    caseTemperature = caseTemperature,
    biasVoltage = biasVoltage,
    vibration = vibration,
    reference = controller.reference,
    force = drive.force) "Vibrating shell";
  Electrodes.PickOff pickOff(
    displacement = resonator.displacement,
    force = controller.acting,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    noise = noise.displacement) "Pick-offs and demodulation";
  Electrodes.Drive drive(
    command = controller.force,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    temperatureRate = resonator.environment.temperatureRate,
    noise = noise.force) "Drives";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives, pick-offs and electronics";
  Controls.Controller controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startGrowthRate = 1/resonator.material.decayTime,
    reading = pickOff.reading,
    amplitudeSetpoint = amplitudeSetpoint,
    phaseOffset = phaseOffset,
    driveOn = driveOn,
    authority = drive.authority,
    virtualRotation = virtualRotation,
    rateNoise = noise.patternRate,
    gainNoise = noise.rotation) "Control electronics";
equation
  gyroAngle = controller.readout.gyroAngle;
  gyroRate = controller.readout.gyroRate;
  patternAngle = controller.detector.patternAngle;
  amplitude = controller.detector.amplitude;
  quadrature = controller.detector.quadrature;
  amplitudeForce = controller.growthRate;
  quadratureForce = controller.quadratureForce;
  frequencyOffset = controller.reference - controller.readout.clockError*resonator.material.frequency;
  valid = controller.startUp.valid;
  annotation (Documentation(info="<html>
<p>The resonator runs in continuous time; the control electronics detect the orbit once per control period
and hold their forces until the next. In the whole-angle mode the pattern is free: it precesses by
-k times the angle of the case, and the gyro measures by reading it. In the force-to-rebalance mode
(<code>controller.forceToRebalance = 1</code>) it is held, and the gyro measures by the rotation it commands.</p>
</html>"));
end HRG;
