within HRG.Gyroscopes;
model HRGElectronics "Control electronics of HRGEnvelope, for HRGPlant"
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0 "Pattern angle at power-on";
  parameter Units.RelativeForce startForce(min = 0, max = 10) = 1/450 "Force on the antinode at power-on: amplitude over decay time";
  parameter Units.DimensionlessRatio bryanFactor(min = 0.01, max = 1) = 0.277 "Bryan factor, by which noise of the rate turns the pattern";
  parameter Units.AngularFrequency frequency(min = 1e3, max = 1e6) = 43982.297150257104 "Nominal modal frequency";
  parameter Units.RelativeForce authority(min = 0, max = 1e6) = 0 "A channel of the drives clips at this force; 0: never";
  input Units.RelativeDisplacement reading[4](start = {1, 0, 0, 0}, each min = -1e6, each max = 1e6, each nominal = 1) "Demodulated displacement {cx, sx, cy, sy}";
  input Units.AngularVelocity virtualRotation(start = 0, min = -10, max = 10, nominal = 0.1) "Commanded virtual rotation, as an input rate";
  input Units.RelativeDisplacement amplitudeSetpoint(start = 1, min = 0.01, max = 10, nominal = 1) "Antinode amplitude to hold";
  input Units.Angle phaseOffset(start = 0, min = -1, max = 1, nominal = 1e-2) "Added to the detected phase";
  input Units.Switch driveOn(start = 1, min = 0, max = 1, nominal = 1) "1 with the drive on, 0 off: ring-down";
  output Units.RelativeForce force[4](each nominal = 1e-2) "Commanded force {cos x, sin x, cos y, sin y}, held for a control period";
  output Units.DampingCoefficient pump(nominal = 2e-3) "Commanded growth by parametric drive, held likewise";
  output Units.AngularFrequency reference(nominal = 1) "Frequency of the reference less the nominal modal one";
  output Units.AngularVelocity commandedRate(nominal = 0.1) "Rate of the modal angle that is commanded by virtual rotation and sweep";
  output Units.Switch isHeld(min = 0, max = 1, nominal = 1) "1: the pattern is held; 0: it is free";
  output Units.Angle gyroAngle(nominal = 1) "Measured angle about the input axis since power-on";
  output Units.AngularVelocity gyroRate(nominal = 0.1) "Measured rate over the last control period";
  output Units.Angle patternAngle(nominal = 1) "Detected pattern angle, continuous";
  output Units.RelativeDisplacement amplitude(min = 0, nominal = 1) "Detected antinode amplitude";
  output Units.RelativeDisplacement quadrature(nominal = 1e-3) "Detected quadrature amplitude";
  output Units.DampingCoefficient amplitudeForce(nominal = 2e-3) "Amplitude-loop force over detected amplitude, as a growth rate";
  output Units.RelativeForce quadratureForce(nominal = 1e-3) "Quadrature-loop force";
  output Units.AngularFrequency frequencyOffset(nominal = 1e-2) "Phase-loop frequency less the nominal one, as the gyro's clock counts it";
  output Units.Switch valid(min = 0, max = 1, nominal = 1) "1 while the output is valid";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    bryanFactor = bryanFactor,
    seed = seed) "Noise of the electronics; that of drives and pick-offs is left to the plant";
  Controls.Controller controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startForce = startForce,
    frequency = frequency,
    reading = reading,
    amplitudeSetpoint = amplitudeSetpoint,
    phaseOffset = phaseOffset,
    driveOn = driveOn,
    authority = authority,
    virtualRotation = virtualRotation,
    rateNoise = noise.patternRate,
    gainNoise = noise.rotation) "Control electronics";
equation
  force = controller.force;
  pump = controller.pump;
  reference = controller.reference;
  commandedRate = controller.commandedTurn;
  isHeld = controller.isHeld;
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
<p>The controller of <code>HRGEnvelope</code> by itself. A sample at the end of a step reads the input <code>reading</code>: step
<code>HRGPlant</code> first and hand its reading on before these electronics make the same step, and the loop has no delay but its own.
Where an importer hands values on between steps only, forces come one control period later.</p>
</html>"));
end HRGElectronics;
