within HRG.Interfaces;
partial block PartialElectronics "Control electronics of a gyro: they read its pick-offs, command its drives and put out its angle"
  parameter Units.Time samplePeriod "Period of the output";
  Boolean tick = sample(0, samplePeriod) "Each period of the output";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.RelativeForce startForce "Force on the antinode at time 0, which holds the amplitude of an ideal gyro";
  parameter Units.AngularFrequency frequency "Nominal modal frequency";
  Inputs.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}"
    annotation (Placement(transformation(extent = {{-120, 78}, {-100, 98}})));
  Inputs.RelativeDisplacement amplitudeSetpoint "Antinode amplitude to hold"
    annotation (Placement(transformation(extent = {{-120, -48}, {-100, -28}})));
  Inputs.Angle phaseOffset "Added to the detected phase"
    annotation (Placement(transformation(extent = {{-120, -72}, {-100, -52}})));
  Inputs.DimensionlessRatio driveOn "1 with amplitude, quadrature and rotation forces on, 0 off (ring-down)"
    annotation (Placement(transformation(extent = {{-120, -98}, {-100, -78}})));
  Inputs.AngularVelocity virtualRotation "Commanded virtual rotation, as an input rate"
    annotation (Placement(transformation(extent = {{-120, -22}, {-100, -2}})));
  Inputs.AngularVelocity rateNoise "Pattern rate by slow noise of the electronics"
    annotation (Placement(transformation(extent = {{-120, 28}, {-100, 48}})));
  Inputs.DimensionlessRatio gainNoise "Relative noise of the commanded rotation"
    annotation (Placement(transformation(extent = {{-120, 2}, {-100, 22}})));
  Inputs.RelativeForce authority "A channel of the drives gives no more than this force; 0: no limit"
    annotation (Placement(transformation(extent = {{-120, 52}, {-100, 72}})));
  Outputs.DampingCoefficient growthRate "Force of the amplitude loop over detected amplitude"
    annotation (Placement(transformation(extent = {{100, -59}, {112, -47}})));
  Outputs.RelativeForce quadratureForce "Force of the quadrature loop"
    annotation (Placement(transformation(extent = {{100, -73}, {112, -61}})));
  Outputs.AngularFrequency reference "Reference frequency less the nominal one"
    annotation (Placement(transformation(extent = {{100, 74}, {112, 86}})));
  Outputs.AngularVelocity commandedTurn "Rate of the modal angle that virtual rotation and sweep command"
    annotation (Placement(transformation(extent = {{100, 34}, {112, 46}})));
  Outputs.RelativeForce force[4] "Commanded force {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{100, 47}, {112, 59}})));
  Outputs.RelativeForce acting[4] "Force that was held up to the sample"
    annotation (Placement(transformation(extent = {{100, 87}, {112, 99}})));
  Outputs.DampingCoefficient pump "Commanded growth by parametric drive"
    annotation (Placement(transformation(extent = {{100, 61}, {112, 73}})));
  Outputs.DimensionlessRatio isHeld "1: the pattern is held; 0: it is free"
    annotation (Placement(transformation(extent = {{100, 21}, {112, 33}})));
  Outputs.Angle gyroAngle "Measured angle of the case since time 0"
    annotation (Placement(transformation(extent = {{100, 7}, {112, 19}})));
  Outputs.AngularVelocity gyroRate "Measured rate of the case over the last period"
    annotation (Placement(transformation(extent = {{100, -6}, {112, 6}})));
  Outputs.Angle patternAngle "Detected pattern angle, continuous"
    annotation (Placement(transformation(extent = {{100, -19}, {112, -7}})));
  Outputs.RelativeDisplacement detectedAmplitude "Detected antinode amplitude"
    annotation (Placement(transformation(extent = {{100, -33}, {112, -21}})));
  Outputs.RelativeDisplacement detectedQuadrature "Detected quadrature amplitude"
    annotation (Placement(transformation(extent = {{100, -46}, {112, -34}})));
  Outputs.AngularFrequency frequencyOffset "Reference frequency less the nominal one, as the clock of the electronics counts it"
    annotation (Placement(transformation(extent = {{100, -86}, {112, -74}})));
  Outputs.DimensionlessRatio valid "1 while the output is valid"
    annotation (Placement(transformation(extent = {{100, -99}, {112, -87}})));
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Line(points = {{-60, -40}, {-20, -40}, {-20, 20}, {20, 20}, {20, -10}, {60, -10}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>What stands in for a gyro's electronics has these connectors. At each <code>tick</code> (<code>when tick then</code>) they sample the reading and command a force, a growth by
parametric drive and a reference frequency, which they hold until the next. <code>acting</code>, the force of the period before, must not depend on the present reading: it feeds
through to the pick-offs.</p>
</html>"));
end PartialElectronics;
