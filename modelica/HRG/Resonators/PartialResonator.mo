within HRG.Resonators;
partial model PartialResonator "Vibrating shell: environment and material; the motion is left to who extends it"
  parameter Units.Time thermalPeriod "Sample period of the environment";
  Boolean thermalTick = sample(0, thermalPeriod) "Each of them";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at time 0";
  parameter Real imbalanceX(unit = "s/m", min = -1e3, max = 1e3) = 0
    "Force on x over in-phase vibration of the case at the modal frequency (mass imbalance), typically 1e-4 to 1e-2: a share of 1e-5 to 1e-3 of the acceleration, at an amplitude of 1 um (estimate)";
  parameter Real imbalanceY(unit = "s/m", min = -1e3, max = 1e3) = 0 "Force on y, likewise, typically 1e-4 to 1e-2";
  Interfaces.Inputs.AngularVelocity angularRate "Inertial rate about the input axis"
    annotation (Placement(transformation(extent = {{-120, 78}, {-100, 98}})));
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  Interfaces.Inputs.Temperature caseTemperature "Temperature of the case"
    annotation (Placement(transformation(extent = {{-120, 52}, {-100, 72}})));
  Interfaces.Inputs.DimensionlessRatio biasVoltage "Electrode bias voltage over the nominal one"
    annotation (Placement(transformation(extent = {{-120, 2}, {-100, 22}})));
  Interfaces.Inputs.DimensionlessRatio dampingFlicker "Relative change of the damping anisotropy by its flicker"
    annotation (Placement(transformation(extent = {{-120, -22}, {-100, -2}})));
  Interfaces.Inputs.Acceleration vibration "Case vibration at the modal frequency, in phase with the reference"
    annotation (Placement(transformation(extent = {{-120, 28}, {-100, 48}})));
  Environment environment(samplePeriod = thermalPeriod, tick = thermalTick, caseTemperature = caseTemperature) "Temperature and age";
  MassDefects massDefects "Harmonics of the rim's mass";
  Material material(
    supportLoss = massDefects.loss,
    supportCos = massDefects.lossCos,
    supportSin = massDefects.lossSin,
    temperature = environment.temperature,
    age = environment.age,
    dampingFlicker = dampingFlicker,
    isDecaying = isDecaying,
    biasVoltage = biasVoltage,
    acceleration = acceleration,
    angularRate = angularRate) "Coefficients of the motion";
protected
  final parameter Units.RelativeDisplacement leastSize = 1e-9 "Size at which a vibration has decayed";
  discrete Units.DimensionlessRatio isDecaying(start = 1, fixed = true) "1 above it; 0 below, where the vibration goes on without damping";
  Units.RelativeDisplacement size "Size of the vibration, of the order of its amplitude";
  final parameter Real forceX(unit = "s/m") = imbalanceX + massDefects.forceX "Force on x over vibration of the case";
  final parameter Real forceY(unit = "s/m") = imbalanceY + massDefects.forceY "Force on y over vibration of the case";
  Units.RelativeForce shake[4] = {forceX*vibration, 0, forceY*vibration, 0} "Force by vibration of the case";
equation
  when thermalTick then
    isDecaying = if size > leastSize then 1 else 0;
  end when;
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Ellipse(extent = {{-70, 50}, {70, -50}}), Ellipse(extent = {{-50, 70}, {50, -70}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>Vibration of the case at the modal frequency acts as a force {imbalanceX, 0, imbalanceY, 0} times its acceleration, to
which the harmonics of the mass add theirs: mechanism 27, B = (f/2k) sin 2 theta for a force f on x.</p>
<p>A ring-down ends at <code>leastSize</code>, below the thermal motion of a shell of 1 g at an amplitude of 1 um, 5e-8 of it. Electronics that divide by the amplitude go on.</p>
</html>"));
end PartialResonator;
