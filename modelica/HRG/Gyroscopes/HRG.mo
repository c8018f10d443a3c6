within HRG.Gyroscopes;
model HRG "Whole-angle hemispherical resonator gyro: complex envelope, electronics sampled at 1 kHz"
  parameter Units.Time decayTime(min = 1, max = 1e5) = 450 "Mean amplitude decay time of the resonator";
  parameter Units.Rate dampingAnisotropy(min = 0, max = 1e-2) = 0 "Difference of 1/tau between the axes of maximum and minimum damping";
  parameter Units.Angle dampingAxis = 0 "Pattern angle of maximum damping";
  parameter Units.AngularFrequency frequencySplit(min = 0, max = 100) = 0 "Difference of the modes' circular frequencies";
  parameter Units.Angle stiffnessAxis = 0 "Pattern angle of the mode of lower frequency";
  parameter Units.Ratio bryanFactor(min = 0.01, max = 1) = 0.277 "Precession of the pattern over rotation of the case";
  parameter Units.Ratio nominalBryanFactor(min = 0.01, max = 1) = 0.277 "Bryan factor that the electronics believe";
  parameter Units.Ratio pickOffGainMismatch(min = -0.5, max = 0.5) = 0 "Pick-off gain of x over that of y, less one";
  parameter Units.Ratio pickOffNonOrthogonality(min = -0.5, max = 0.5) = 0 "Share of x that the pick-off of y reads";
  parameter Units.Ratio driveGainMismatch(min = -0.5, max = 0.5) = 0 "Drive gain of x over that of y, less one";
  parameter Units.Ratio driveNonOrthogonality(min = -0.5, max = 0.5) = 0 "Share of the x force that drives y";
  parameter Units.Angle phaseError(min = -1, max = 1) = 0 "Phase that the demodulation adds";
  parameter Units.AngleNoiseDensity forceNoiseDensity(max = 1) = 0
    "White force noise, as the square of the angle random walk coefficient it causes at nominal amplitude";
  parameter Units.DisplacementNoiseDensity pickOffNoiseDensity(max = 1) = 0
    "White noise of each demodulated channel, relative to the nominal amplitude";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle = 0 "Pattern angle at power-on";
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  parameter Units.AngularFrequency phaseLoopFrequency(min = 0.1, max = 500) = 200 "Natural frequency of the phase loop";
  parameter Units.AngularFrequency amplitudeLoopFrequency(min = 0.1, max = 500) = 6 "Natural frequency of the amplitude loop";
  parameter Units.AngularFrequency quadratureLoopFrequency(min = 0.1, max = 500) = 6 "Natural frequency of the quadrature loop";
  input Units.AngularRate angularRate(start = 0, min = -100, max = 100) "Inertial rate about the input axis";
  input Units.AngularRate virtualRotation(start = 0, min = -10, max = 10) "Commanded virtual rotation, as an input rate";
  output Units.Angle gyroAngle "Measured angle about the input axis since power-on";
  output Units.Angle patternAngle "Detected pattern angle, continuous";
  output Units.Displacement amplitude "Detected antinode amplitude";
  output Units.Rate amplitudeForce "Amplitude-loop force over detected amplitude, as a growth rate";
  output Units.Force quadratureForce "Quadrature-loop force";
  output Units.AngularFrequency frequencyOffset "Phase-loop frequency less the nominal one";
  Resonators.AnisotropicEnvelope resonator(
    decayTime = decayTime,
    dampingAnisotropy = dampingAnisotropy,
    dampingAxis = dampingAxis,
    frequencySplit = frequencySplit,
    stiffnessAxis = stiffnessAxis,
    bryanFactor = bryanFactor,
    startAngle = startAngle) "Vibrating shell";
  Electrodes.PickOff pickOff(
    gainMismatch = pickOffGainMismatch,
    nonOrthogonality = pickOffNonOrthogonality,
    phaseError = phaseError) "Pick-offs and demodulation";
  Electrodes.Drive drive(gainMismatch = driveGainMismatch, nonOrthogonality = driveNonOrthogonality) "Drives";
  Noise.ChannelNoise noise(
    samplePeriod = samplePeriod,
    seed = seed,
    forceDensity = 4*bryanFactor^2*forceNoiseDensity,
    pickOffDensity = pickOffNoiseDensity) "Noise of drives and pick-offs";
  Controls.WholeAngleController controller(
    samplePeriod = samplePeriod,
    phaseLoopFrequency = phaseLoopFrequency,
    amplitudeLoopFrequency = amplitudeLoopFrequency,
    quadratureLoopFrequency = quadratureLoopFrequency,
    decayTime = decayTime,
    bryanFactor = nominalBryanFactor,
    startAngle = startAngle) "Control electronics";
equation
  resonator.angularRate = angularRate;
  resonator.detuning = controller.detuning;
  resonator.force = drive.force;
  pickOff.envelope = resonator.envelope;
  pickOff.noise = noise.pickOff;
  controller.reading = pickOff.reading;
  controller.virtualRotation = virtualRotation;
  drive.command = controller.force;
  drive.noise = noise.force;
  gyroAngle = controller.gyroAngle;
  patternAngle = controller.detector.patternAngle;
  amplitude = controller.detector.amplitude;
  amplitudeForce = controller.amplitudeLoop.command;
  quadratureForce = controller.quadratureLoop.command;
  frequencyOffset = controller.detuning;
  annotation (Documentation(info="<html>
<p>The resonator runs in continuous time; the control electronics detect the orbit once per control period
and hold their forces until the next. In the whole-angle mode the pattern is free: it precesses by
-k times the angle of the case, and the gyro measures by reading it.</p>
</html>"));
end HRG;
