within HRG.Gyroscopes;
model HRGEnvelope "Whole-angle hemispherical resonator gyro: complex envelope, electronics sampled at 1 kHz"
  extends Interfaces.PartialGyro;
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  Electrodes.Ring ring "Electrodes around the shell";
  Resonators.Resonator resonator(
    final thermalPeriod = 1e-2,
    material(ringErrors = ring.errors),
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
  Electrodes.PickOff pickOff(
    ringErrors = ring.errors,
    displacement = resonator.displacement,
    force = controller.acting,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    gradient = resonator.environment.gradient,
    age = resonator.environment.age,
    turning = controller.commandedTurn - (1 - controller.forceToRebalance)*resonator.material.coupling,
    biasVoltage = biasVoltage,
    gainFlicker = flicker.gain,
    phaseFlicker = flicker.phase,
    noise = noise.displacement) "Pick-offs and demodulation";
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
    seed = seed) "Flicker of coefficients of the shell and the pick-offs";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives, pick-offs and electronics";
  Controls.Controller controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startForce = startAmplitude/resonator.material.decayTime,
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
<p>x = cx cos P + sx sin P, y alike, P the phase of the reference, Z = [cx - i sx; cy - i sy] the complex envelope:</p>
<pre>Z' = -i nu Z - Z/tau - (D/2) [[ct, st], [st, -ct]] Z - (i dw/2) [[cw, sw], [sw, -cw]] Z + 2 k Omega [[0, 1], [-1, 0]] Z + U
U = [[c, -s], [s, c]] [A; N - i S]
angle = (commanded angle - theta)/k - integral of the bias map</pre>
<p>ct = cos 4 theta_tau, cw = cos 4 theta_w, c and s those of the detected modal angle 2 theta; A, N and S are the forces on antinode, node, and
node in quadrature. In the elements of the orbit, amplitude a and quadrature q, this gives, without errors of the
electrodes and without Duffing stiffness, the averaged equation of the pattern (D. D. Lynch;
Eq. (1) of Xu et al. 2024, with its axes, factors and signs mended):</p>
<pre>theta' = -k Omega + (D/4) sin 4(theta - theta_tau) (a^2 + q^2)/(a^2 - q^2) + (dw/2) cos 4(theta - theta_w) a q/(a^2 - q^2) + a N/(2 (a^2 - q^2))</pre>
<p>The resonator runs in continuous time; the control electronics detect the orbit once per control period
and hold their forces until the next. In the whole-angle mode the pattern is free: it precesses by
-k times the angle of the case, and the gyro measures by reading it. In the force-to-rebalance mode
(<code>controller.forceToRebalance = 1</code>) it is held, and the gyro measures by the rotation it commands.</p>
</html>"));
end HRGEnvelope;
