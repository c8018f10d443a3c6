within HRG.Gyroscopes;
model HRGSlow "Whole-angle hemispherical resonator gyro with its loops quasi-steady, for hours and for thousands"
  extends Interfaces.PartialGyro;
  parameter Units.Time samplePeriod(min = 0.01, max = 1) = 0.1 "Period of output and noise; loops settle within a few";
  Electrodes.Ring ring "Electrodes around the shell";
  Resonators.OrbitResonator resonator(
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    angularRate = angularRate,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    caseTemperature = caseTemperature,
    biasVoltage = biasVoltage,
    dampingFlicker = flicker.damping,
    vibration = vibration,
    final thermalPeriod = samplePeriod,
    material(ringErrors = ring.errors),
    rates = controller.rates) "Vibrating shell";
  Electrodes.PickOff pickOff(
    ringErrors = ring.errors,
    forceTime = (1 - controller.timeDivision)*pickOff.feedthrough - controller.timeDivision*controller.synthesis.controlPeriod/2,
    displacement = resonator.orbit.displacement,
    force = controller.force,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    gradient = resonator.environment.gradient,
    rise = {0, 0},
    missing = 0,
    age = resonator.environment.age,
    turning = controller.commandedTurn - (1 - controller.forceToRebalance)*resonator.material.coupling,
    biasVoltage = biasVoltage,
    gainFlicker = flicker.gain,
    phaseFlicker = flicker.phase,
    noise = noise.displacement) "Pick-offs and demodulation";
  Electrodes.DriveErrors drive(
    ringErrors = ring.errors,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    biasVoltage = biasVoltage,
    temperatureRate = resonator.environment.temperatureRate) "Drives";
  Noise.CoefficientFlicker flicker(
    samplePeriod = resonator.thermalPeriod,
    seed = seed) "Flicker of coefficients of the shell and the pick-offs";
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    bryanFactor = resonator.material.bryanFactor,
    final pickOffPeriod = 1e-3 + 2*controller.demodulation.filterDelay/(1 + controller.timeDivision),
    seed = seed) "Noise of drives, pick-offs and electronics";
  Controls.QuasisteadyController controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startForce = startAmplitude/resonator.material.decayTime,
    frequency = resonator.material.frequency,
    reading = pickOff.reading,
    amplitudeSetpoint = amplitudeSetpoint,
    phaseOffset = phaseOffset,
    driveOn = driveOn,
    virtualRotation = virtualRotation,
    rateNoise = noise.patternRate,
    gainNoise = noise.rotation,
    freeRates = resonator.freeRates + noise.force,
    amplitude = resonator.orbit.amplitude,
    quadrature = resonator.orbit.quadrature,
    phase = resonator.orbit.phase,
    modalAngle = resonator.orbit.modalAngle,
    axes = resonator.orbit.axes,
    coupling = resonator.material.coupling,
    analogue = pickOff.analogue,
    driveGain = drive.gain,
    pumpGain = drive.pumpGain,
    authority = drive.authority) "Control electronics";
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
<p>With h = exp(-i phi) (Z' of the free envelope + U) on the antinode (a) and the node (n), the orbit of pattern angle theta, amplitude
a, quadrature q and phase phi moves by (Z' the rate of <code>Resonators.envelopeRates</code>, U the force of the drives, nu the frequency
of the reference)</p>
<pre>a' = Re h_a
q' = -Im h_n
2 theta' = (a Re h_n - q Im h_a)/(a^2 - q^2)
phi' + nu = (a Im h_a - q Re h_n)/(a^2 - q^2)</pre>
<p>with a force N on the node and without errors of the electrodes and Duffing stiffness (D. D. Lynch; Eq. (1) of Xu et al. 2024, with its axes, factors and signs mended)</p>
<pre>theta' = -k Omega + (D/4) sin 4(theta - theta_tau) (a^2 + q^2)/(a^2 - q^2) + (dw/2) cos 4(theta - theta_w) a q/(a^2 - q^2) + a N/(2 (a^2 - q^2))</pre>
<p>The same parts, parameters and closed forms as <code>HRGEnvelope</code>, but forces follow from the condition that the loops are
at rest, so that only the pattern moves, and a step may last a second. The state is the orbit, in which rotation is a
straight line. Noise of pick-offs is that of one control period, read once per output. Outputs change once in a sample period:
communication steps are best whole multiples of it, and results then don't depend on them.</p>
<p>The loops of <code>HRGEnvelope</code> follow a turning pattern with a lag that is not in here. It matters where the split is large:
while the case turns at W the output loses (W/2)(dw/w)^2 (1 + cos 8(theta - theta_w)) of rate, w the natural frequency of the quadrature loop:
1.4e-7 of W at 0.5 mHz, 2.2e-6 at 2 mHz (<code>HRG.Validation.Stiffness.SplitLag</code>).</p>
</html>"));
end HRGSlow;
