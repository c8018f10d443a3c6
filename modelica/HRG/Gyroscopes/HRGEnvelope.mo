within HRG.Gyroscopes;
model HRGEnvelope "Whole-angle hemispherical resonator gyro: complex envelope, electronics sampled at 1 kHz"
  extends Interfaces.PartialGyro;
  final parameter Units.Time samplePeriod = 1e-3 "Control period";
  Electrodes.Ring ring "Electrodes around the shell"
    annotation (Placement(transformation(extent = {{150, 100}, {190, 140}})));
  Resonators.Resonator resonator(
    samplePeriod = samplePeriod,
    tick = tick,
    material(ringErrors = ring.errors),
    startAngle = startAngle,
    startAmplitude = startAmplitude,
    acceleration = {accelerationX, accelerationY, accelerationZ}) "Vibrating shell"
    annotation (Placement(transformation(extent = {{-36, 20}, {36, 100}})));
  Electrodes.PickOff pickOff(
    ringErrors = ring.errors,
    temperature = resonator.environment.temperature,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    gradient = resonator.environment.gradient,
    rise = resonator.interpolation.rise,
    missing = resonator.interpolation.missing,
    age = resonator.environment.age,
    turning = controller.commandedTurn - (1 - controller.isHeld)*resonator.material.coupling) "Pick-offs and demodulation"
    annotation (Placement(transformation(extent = {{76, 40}, {116, 100}})));
  Electrodes.Drive drive(
    ringErrors = ring.errors,
    acceleration = {accelerationX, accelerationY, accelerationZ},
    temperatureRate = resonator.environment.temperatureRate) "Drives"
    annotation (Placement(transformation(extent = {{-110, 20}, {-70, 60}})));
  Noise.CoefficientFlicker flicker(
    samplePeriod = resonator.thermalPeriod,
    tick = resonator.thermalTick,
    seed = seed) "Flicker of coefficients of the shell and the pick-offs"
    annotation (Placement(transformation(extent = {{-110, 108}, {-70, 138}})));
  Noise.ElectronicsNoise noise(
    samplePeriod = samplePeriod,
    tick = tick,
    bryanFactor = resonator.material.bryanFactor,
    seed = seed) "Noise of drives, pick-offs and electronics"
    annotation (Placement(transformation(extent = {{-150, -60}, {-110, -20}})));
  replaceable Controls.Controller controller(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startForce = startAmplitude/resonator.material.decayTime,
    frequency = resonator.material.frequency,
    authority = drive.authority) "Control electronics; redeclared, a controller of one's own closes the loops"
    constrainedby Interfaces.PartialElectronics(
    samplePeriod = samplePeriod,
    startAngle = startAngle,
    startForce = startAmplitude/resonator.material.decayTime,
    frequency = resonator.material.frequency,
    authority = drive.authority)
    annotation (choicesAllMatching = true, Placement(transformation(extent = {{-36, -128}, {36, -8}})));
protected
  Boolean tick = sample(0, samplePeriod) "The one clock: each control period";
equation
  connect(angularRate, resonator.angularRate)
    annotation (Line(points = {{-206, 95}, {-60, 95}, {-60, 95.2}, {-39.6, 95.2}}, color = {0, 0, 127}));
  connect(caseTemperature, resonator.caseTemperature)
    annotation (Line(points = {{-206, 85}, {-56, 85}, {-56, 84.8}, {-39.6, 84.8}}, color = {0, 0, 127}));
  connect(vibration, resonator.vibration)
    annotation (Line(points = {{-206, 75}, {-52, 75}, {-52, 75.2}, {-39.6, 75.2}}, color = {0, 0, 127}));
  connect(biasVoltage, resonator.biasVoltage)
    annotation (Line(points = {{-206, 65}, {-48, 65}, {-48, 64.8}, {-39.6, 64.8}}, color = {0, 0, 127}));
  connect(biasVoltage, pickOff.biasVoltage)
    annotation (Line(points = {{-206, 65}, {-130, 65}, {-130, 14}, {62, 14}, {62, 64.9}, {74, 64.9}}, color = {0, 0, 127}));
  connect(biasVoltage, drive.biasVoltage)
    annotation (Line(points = {{-206, 65}, {-130, 65}, {-130, 55}, {-112, 55}}, color = {0, 0, 127}));
  connect(flicker.damping, resonator.dampingFlicker)
    annotation (Line(points = {{-68, 113}, {-64, 113}, {-64, 55.2}, {-39.6, 55.2}}, color = {0, 0, 127}));
  connect(flicker.gain, pickOff.gainFlicker)
    annotation (Line(points = {{-68, 133.1}, {66, 133.1}, {66, 94.9}, {74, 94.9}}, color = {0, 0, 127}));
  connect(flicker.phase, pickOff.phaseFlicker)
    annotation (Line(points = {{-68, 123}, {62, 123}, {62, 85}, {74, 85}}, color = {0, 0, 127}));
  connect(resonator.displacement, pickOff.displacement)
    annotation (Line(points = {{39.6, 60}, {56, 60}, {56, 75.1}, {74, 75.1}}, color = {0, 0, 127}));
  connect(pickOff.reading, controller.reading)
    annotation (Line(points = {{118, 70}, {128, 70}, {128, 10}, {-60, 10}, {-60, -15.2}, {-39.6, -15.2}}, color = {0, 0, 127}));
  connect(controller.force, drive.command)
    annotation (Line(points = {{38.2, -36.2}, {54, -36.2}, {54, -2}, {-126, -2}, {-126, 25}, {-112, 25}}, color = {0, 0, 127}));
  connect(controller.pump, drive.pump)
    annotation (Line(points = {{38.2, -27.8}, {50, -27.8}, {50, 2}, {-122, 2}, {-122, 35}, {-112, 35}}, color = {0, 0, 127}));
  connect(controller.acting, pickOff.force)
    annotation (Line(points = {{38.2, -12.2}, {58, -12.2}, {58, 55}, {74, 55}}, color = {0, 0, 127}));
  connect(controller.reference, resonator.reference)
    annotation (Line(points = {{38.2, -20}, {46, -20}, {46, 6}, {-44, 6}, {-44, 44.8}, {-39.6, 44.8}}, color = {0, 0, 127}));
  connect(drive.force, resonator.force)
    annotation (Line(points = {{-68, 30}, {-56, 30}, {-56, 24.8}, {-39.6, 24.8}}, color = {0, 0, 127}));
  connect(drive.pumping, resonator.pumping)
    annotation (Line(points = {{-68, 50}, {-60, 50}, {-60, 35.2}, {-39.6, 35.2}}, color = {0, 0, 127}));
  connect(noise.force, drive.noise)
    annotation (Line(points = {{-108, -25}, {-104, -25}, {-104, 6}, {-118, 6}, {-118, 45}, {-112, 45}}, color = {0, 0, 127}));
  connect(noise.displacement, pickOff.noise)
    annotation (Line(points = {{-108, -35}, {-100, -35}, {-100, -3}, {70, -3}, {70, 45.1}, {74, 45.1}}, color = {0, 0, 127}));
  connect(noise.patternRate, controller.rateNoise)
    annotation (Line(points = {{-108, -45}, {-70, -45}, {-70, -45.2}, {-39.6, -45.2}}, color = {0, 0, 127}));
  connect(noise.rotation, controller.gainNoise)
    annotation (Line(points = {{-108, -55}, {-74, -55}, {-74, -60.8}, {-39.6, -60.8}}, color = {0, 0, 127}));
  connect(virtualRotation, controller.virtualRotation)
    annotation (Line(points = {{-206, -70}, {-80, -70}, {-80, -75.2}, {-39.6, -75.2}}, color = {0, 0, 127}));
  connect(amplitudeSetpoint, controller.amplitudeSetpoint)
    annotation (Line(points = {{-206, -84}, {-76, -84}, {-76, -90.8}, {-39.6, -90.8}}, color = {0, 0, 127}));
  connect(phaseOffset, controller.phaseOffset)
    annotation (Line(points = {{-206, -98}, {-72, -98}, {-72, -105.2}, {-39.6, -105.2}}, color = {0, 0, 127}));
  connect(driveOn, controller.driveOn)
    annotation (Line(points = {{-206, -112}, {-68, -112}, {-68, -120.8}, {-39.6, -120.8}}, color = {0, 0, 127}));
  connect(controller.gyroAngle, gyroAngle)
    annotation (Line(points = {{38.2, -60.2}, {38.2, -60}, {206, -60}}, color = {0, 0, 127}));
  connect(controller.gyroRate, gyroRate)
    annotation (Line(points = {{38.2, -68}, {206, -68}}, color = {0, 0, 127}));
  connect(controller.patternAngle, patternAngle)
    annotation (Line(points = {{38.2, -75.8}, {38.2, -76}, {206, -76}}, color = {0, 0, 127}));
  connect(controller.detectedAmplitude, amplitude)
    annotation (Line(points = {{38.2, -84.2}, {38.2, -84}, {206, -84}}, color = {0, 0, 127}));
  connect(controller.detectedQuadrature, quadrature)
    annotation (Line(points = {{38.2, -92}, {206, -92}}, color = {0, 0, 127}));
  connect(controller.growthRate, amplitudeForce)
    annotation (Line(points = {{38.2, -99.8}, {38.2, -100}, {206, -100}}, color = {0, 0, 127}));
  connect(controller.quadratureForce, quadratureForce)
    annotation (Line(points = {{38.2, -108.2}, {38.2, -108}, {206, -108}}, color = {0, 0, 127}));
  connect(controller.frequencyOffset, frequencyOffset)
    annotation (Line(points = {{38.2, -116}, {206, -116}}, color = {0, 0, 127}));
  connect(controller.valid, valid)
    annotation (Line(points = {{38.2, -123.8}, {38.2, -124}, {206, -124}}, color = {0, 0, 127}));
  annotation (Diagram(coordinateSystem(extent = {{-200, -140}, {200, 140}})),
    Documentation(info="<html>
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
