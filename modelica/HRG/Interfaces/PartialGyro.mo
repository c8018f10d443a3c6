within HRG.Interfaces;
partial model PartialGyro "Inputs, outputs and power-on of a gyro, alike in all fidelities"
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0 "Pattern angle at power-on";
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at power-on";
  Inputs.AngularVelocity angularRate(start = 0, min = -100, max = 100, nominal = 0.1) "Inertial rate about the input axis"
    annotation (Placement(transformation(extent = {{-210, 91}, {-202, 99}}), iconTransformation(extent = {{-112, 84}, {-100, 96}})));
  Inputs.AngularVelocity virtualRotation(start = 0, min = -10, max = 10, nominal = 0.1) "Commanded virtual rotation, as an input rate"
    annotation (Placement(transformation(extent = {{-210, -74}, {-202, -66}}), iconTransformation(extent = {{-112, -42}, {-100, -30}})));
  Inputs.Acceleration accelerationX(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the x electrodes"
    annotation (Placement(transformation(extent = {{-210, 36}, {-202, 44}}), iconTransformation(extent = {{-112, 12}, {-100, 24}})));
  Inputs.Acceleration accelerationY(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force across the x electrodes"
    annotation (Placement(transformation(extent = {{-210, 26}, {-202, 34}}), iconTransformation(extent = {{-112, -6}, {-100, 6}})));
  Inputs.Acceleration accelerationZ(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the input axis"
    annotation (Placement(transformation(extent = {{-210, 16}, {-202, 24}}), iconTransformation(extent = {{-112, -24}, {-100, -12}})));
  Inputs.Temperature caseTemperature(start = 298.15, min = 100, max = 500, nominal = 300) "Temperature of the case"
    annotation (Placement(transformation(extent = {{-210, 81}, {-202, 89}}), iconTransformation(extent = {{-112, 66}, {-100, 78}})));
  Inputs.DimensionlessRatio biasVoltage(start = 1, min = 0, max = 10, nominal = 1) "Electrode bias voltage over the nominal one"
    annotation (Placement(transformation(extent = {{-210, 61}, {-202, 69}}), iconTransformation(extent = {{-112, 30}, {-100, 42}})));
  Inputs.Acceleration vibration(start = 0, min = -1e5, max = 1e5, nominal = 1) "Case vibration at the modal frequency, in phase"
    annotation (Placement(transformation(extent = {{-210, 71}, {-202, 79}}), iconTransformation(extent = {{-112, 48}, {-100, 60}})));
  Inputs.RelativeDisplacement amplitudeSetpoint(start = 1, min = 0.01, max = 10, nominal = 1) "Antinode amplitude to hold"
    annotation (Placement(transformation(extent = {{-210, -88}, {-202, -80}}), iconTransformation(extent = {{-112, -60}, {-100, -48}})));
  Inputs.Angle phaseOffset(start = 0, min = -1, max = 1, nominal = 1e-2) "Added to the detected phase"
    annotation (Placement(transformation(extent = {{-210, -102}, {-202, -94}}), iconTransformation(extent = {{-112, -78}, {-100, -66}})));
  Inputs.Switch driveOn(start = 1, min = 0, max = 1, nominal = 1) "1 with the drive on, 0 off: ring-down"
    annotation (Placement(transformation(extent = {{-210, -116}, {-202, -108}}), iconTransformation(extent = {{-112, -96}, {-100, -84}})));
  Outputs.Angle gyroAngle(nominal = 1) "Measured angle about the input axis since power-on"
    annotation (Placement(transformation(extent = {{202, -64}, {210, -56}}), iconTransformation(extent = {{100, 74}, {112, 86}})));
  Outputs.AngularVelocity gyroRate(nominal = 0.1) "Measured rate over the last control period"
    annotation (Placement(transformation(extent = {{202, -72}, {210, -64}}), iconTransformation(extent = {{100, 54}, {112, 66}})));
  Outputs.Angle patternAngle(nominal = 1) "Detected pattern angle, continuous"
    annotation (Placement(transformation(extent = {{202, -80}, {210, -72}}), iconTransformation(extent = {{100, 34}, {112, 46}})));
  Outputs.RelativeDisplacement amplitude(min = 0, nominal = 1) "Detected antinode amplitude"
    annotation (Placement(transformation(extent = {{202, -88}, {210, -80}}), iconTransformation(extent = {{100, 14}, {112, 26}})));
  Outputs.RelativeDisplacement quadrature(nominal = 1e-3) "Detected quadrature amplitude"
    annotation (Placement(transformation(extent = {{202, -96}, {210, -88}}), iconTransformation(extent = {{100, -6}, {112, 6}})));
  Outputs.DampingCoefficient amplitudeForce(nominal = 2e-3) "Amplitude-loop force over detected amplitude, as a growth rate"
    annotation (Placement(transformation(extent = {{202, -104}, {210, -96}}), iconTransformation(extent = {{100, -26}, {112, -14}})));
  Outputs.RelativeForce quadratureForce(nominal = 1e-3) "Quadrature-loop force"
    annotation (Placement(transformation(extent = {{202, -112}, {210, -104}}), iconTransformation(extent = {{100, -46}, {112, -34}})));
  Outputs.AngularFrequency frequencyOffset(nominal = 1e-2) "Phase-loop frequency less the nominal one, as the gyro's clock counts it"
    annotation (Placement(transformation(extent = {{202, -120}, {210, -112}}), iconTransformation(extent = {{100, -66}, {112, -54}})));
  Outputs.Switch valid(min = 0, max = 1, nominal = 1) "1 while the output is valid"
    annotation (Placement(transformation(extent = {{202, -128}, {210, -120}}), iconTransformation(extent = {{100, -86}, {112, -74}})));
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}, lineColor = {0, 0, 127}), Ellipse(extent = {{-70, 50}, {70, -50}}), Ellipse(extent = {{-50, 70}, {50, -70}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Diagram(coordinateSystem(extent = {{-200, -140}, {200, 140}})),
    Documentation(info="<html>
<p>What every fidelity shows. Rates are input rates: a virtual rotation V turns the pattern at k V. All forces are growths of
the envelope, in 1/s: <code>amplitudeForce</code> at rest is the mean damping, 1/tau.</p>
</html>"));
end PartialGyro;
