within HRG.Gyroscopes;
model HRG "Whole-angle hemispherical resonator gyro: complex envelope, electronics sampled at 1 kHz"
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0 "Pattern angle at power-on";
  parameter Units.Displacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at power-on";
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  input Units.AngularRate angularRate(start = 0, min = -100, max = 100) "Inertial rate about the input axis";
  input Units.AngularRate virtualRotation(start = 0, min = -10, max = 10) "Commanded virtual rotation, as an input rate";
  input Units.Acceleration accelerationX(start = 0, min = -1e5, max = 1e5) "Specific force along the x electrodes";
  input Units.Acceleration accelerationY(start = 0, min = -1e5, max = 1e5) "Specific force across the x electrodes";
  input Units.Acceleration accelerationZ(start = 0, min = -1e5, max = 1e5) "Specific force along the input axis";
  input Units.Temperature caseTemperature(start = 298.15, min = 100, max = 500) "Temperature of the case";
  input Units.Ratio biasVoltage(start = 1, min = 0, max = 10) "Electrode bias voltage over the nominal one";
  input Units.Acceleration vibration(start = 0, min = -1e5, max = 1e5) "Case vibration at the modal frequency, in phase";
  input Units.Displacement amplitudeSetpoint(start = 1, min = 0.01, max = 10) "Antinode amplitude to hold";
  input Units.Angle phaseOffset(start = 0, min = -1, max = 1) "Added to the detected phase";
  input Units.Ratio driveOn(start = 1, min = 0, max = 1) "1 with the drive on, 0 off: ring-down";
  output Units.Angle gyroAngle "Measured angle about the input axis since power-on";
  output Units.AngularRate gyroRate "Measured rate over the last control period";
  output Units.Angle patternAngle "Detected pattern angle, continuous";
  output Units.Displacement amplitude "Detected antinode amplitude";
  output Units.Displacement quadrature "Detected quadrature amplitude";
  output Units.Rate amplitudeForce "Amplitude-loop force over detected amplitude, as a growth rate";
  output Units.Force quadratureForce "Quadrature-loop force";
  output Units.AngularFrequency frequencyOffset "Phase-loop frequency less the nominal one, as the gyro's clock counts it";
  output Units.Ratio valid "1 while the output is valid";
  Resonators.Resonator resonator(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startAmplitude = startAmplitude) "Vibrating shell";
  Electrodes.PickOff pickOff "Pick-offs and demodulation";
  Electrodes.Drive drive "Drives";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives, pick-offs and electronics";
  Controls.Controller controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startGrowthRate = 1/resonator.material.decayTime) "Control electronics";
equation
  resonator.angularRate = angularRate;
  resonator.acceleration = {accelerationX, accelerationY, accelerationZ};
  resonator.caseTemperature = caseTemperature;
  resonator.biasVoltage = biasVoltage;
  resonator.vibration = vibration;
  resonator.reference = controller.reference;
  resonator.force = drive.force;
  pickOff.displacement = resonator.displacement;
  pickOff.force = controller.acting;
  pickOff.temperature = resonator.environment.temperature;
  pickOff.acceleration = {accelerationX, accelerationY, accelerationZ};
  pickOff.noise = noise.displacement;
  controller.reading = pickOff.reading;
  controller.amplitudeSetpoint = amplitudeSetpoint;
  controller.phaseOffset = phaseOffset;
  controller.driveOn = driveOn;
  controller.virtualRotation = virtualRotation;
  controller.rateNoise = noise.patternRate;
  controller.gainNoise = noise.rotation;
  drive.command = controller.force;
  drive.acceleration = {accelerationX, accelerationY, accelerationZ};
  drive.temperatureRate = resonator.environment.temperatureRate;
  drive.noise = noise.force;
  gyroAngle = controller.readout.gyroAngle;
  gyroRate = controller.readout.gyroRate;
  patternAngle = controller.detector.patternAngle;
  amplitude = controller.detector.amplitude;
  quadrature = controller.detector.quadrature;
  amplitudeForce = controller.amplitudeLoop.command;
  quadratureForce = controller.quadratureLoop.command;
  frequencyOffset = controller.reference - controller.readout.clockError*resonator.material.frequency;
  valid = controller.startUp.valid;
  annotation (Documentation(info="<html>
<p>The resonator runs in continuous time; the control electronics detect the orbit once per control period
and hold their forces until the next. In the whole-angle mode the pattern is free: it precesses by
-k times the angle of the case, and the gyro measures by reading it. In the force-to-rebalance mode
(<code>controller.forceToRebalance = 1</code>) it is held, and the gyro measures by the rotation it commands.</p>
</html>"));
end HRG;
