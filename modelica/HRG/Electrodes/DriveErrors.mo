within HRG.Electrodes;
block DriveErrors "Errors of the drives"
  parameter Units.Angle frameRotation(min = -0.5, max = 0.5) = 0
    "e: drive electrodes turned against the pick-offs, on the modal axes, typically 1e-4 to 2e-3 raw";
  parameter Real rotationPerAcceleration[3](each unit = "rad.s2/m", each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of e with specific force, typically 1e-7 to 2e-6: a bias of 1e-3 to 2e-2 deg/h/g, -1/(2 k tau) times it at tau = 450 s";
  parameter Real rotationPerTemperatureRate(unit = "rad.s/K", min = -1e3, max = 1e3) = 0
    "Change of e with the rate of the case's temperature (gradients), typically 7e-4 to 1.5e-2: a bias of 1e-3 to 2e-2 deg/h/K times the 10 K that a lag of 600 s leaves at 1 K/min";
  parameter Units.DimensionlessRatio nonOrthogonality(min = -0.5, max = 0.5) = 0 "nd: y drives fy + nd fx, typically 1e-4 to 2e-3 raw";
  parameter Units.DimensionlessRatio gainMismatch(min = -0.5, max = 0.5) = 0
    "gd: x drives (1 + gd/2) fx, y drives (1 - gd/2) fy; typically 1e-3 to 1e-2 raw, 1e-5 to 1e-4 calibrated";
  parameter Units.RelativeForce authority(min = 0, max = 1e6) = 0 "A channel clips at this force, typically 0.01 to 0.2: a virtual rotation of 1 to 20 deg/s takes as much; 0: never";
  parameter Units.DimensionlessRatio gainPerVoltage(min = -2, max = 2) = 0
    "Change of both gains with the bias voltage over the nominal one, typically 1: a force is bias times command";
  parameter Units.DimensionlessRatio pumpAnisotropy(min = -0.5, max = 0.5) = 0
    "Of the parametric drive: it pumps more along its axis and less across it by this share, typically 1e-4 to 5e-3 (estimate)";
  parameter Units.Angle pumpAxis(min = -1000, max = 1000) = 0 "Pattern angle at which it pumps most";
  parameter Units.DimensionlessRatio ringErrors[9] "Errors of the electrode ring, as of ringErrors";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  Interfaces.Inputs.DimensionlessRatio biasVoltage "Over the nominal one"
    annotation (Placement(transformation(extent = {{-120, 65}, {-100, 85}})));
  input Real temperatureRate(unit = "K/s") "Rate of the case's temperature";
  output Units.DimensionlessRatio gain[4] "Force over command, {x by x, x by y, y by x, y by y}";
  output Units.DimensionlessRatio pumpGain[3] "Growth by parametric drive over the command, of x, of y and between them";
protected
  final parameter Units.DimensionlessRatio share = nonOrthogonality + ringErrors[6] "Share of fx in fy";
  final parameter Units.DimensionlessRatio scaleX = (1 + ringErrors[4])*(1 + (gainMismatch + ringErrors[5])/2) "Gain of x";
  final parameter Units.DimensionlessRatio scaleY = (1 + ringErrors[4])*(1 - (gainMismatch + ringErrors[5])/2) "Gain of y";
  final parameter Units.DimensionlessRatio pumpCos = pumpAnisotropy*cos(4*pumpAxis) + ringErrors[8] "Anisotropy of parametric drive, diagonal";
  final parameter Units.DimensionlessRatio pumpSin = pumpAnisotropy*sin(4*pumpAxis) + ringErrors[9] "Anisotropy of parametric drive, off diagonal";
  Units.Angle rotation "e under specific force and gradients";
  Units.DimensionlessRatio strength "Mean gain under the bias voltage";
  Units.DimensionlessRatio turn[2] "Cosine and sine of e, times the mean gain";
equation
  rotation = frameRotation + ringErrors[7] + rotationPerTemperatureRate*temperatureRate
    + rotationPerAcceleration[1]*acceleration[1] + rotationPerAcceleration[2]*acceleration[2]
    + rotationPerAcceleration[3]*acceleration[3];
  strength = 1 + gainPerVoltage*(biasVoltage - 1);
  turn = {strength*cos(rotation), strength*sin(rotation)};
  gain = {
    scaleX*turn[1],
    -scaleX*turn[2],
    scaleY*(turn[2] + share*turn[1]),
    scaleY*(turn[1] - share*turn[2])};
  pumpGain = {strength*(1 + pumpCos), strength*(1 - pumpCos), strength*pumpSin};
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Line(points = {{-20, 60}, {-20, -60}}), Line(points = {{20, 60}, {20, -60}}), Line(points = {{-100, 0}, {-20, 0}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>Of the command {x, y}, which the electronics keep within the authority,</p>
<pre>force = (1 + gainPerVoltage (V - 1)) [[1 + gd/2, 0], [0, 1 - gd/2]] [[1, 0], [nd, 1]] [[cos e, -sin e], [sin e, cos e]] {x, y}
e = frameRotation + rotationPerTemperatureRate dT/dt + rotationPerAcceleration f</pre>
<p>f the specific force, T the case's temperature, V the bias voltage over the nominal one. The electrode ring adds its gd, nd and e, and scales both gains. Mechanisms 3, 5, 6, 24, 25, 28 and 30 of the catalogue.</p>
<p>Parametric drive modulates the bias voltage of all electrodes at twice the reference frequency, and with it their softening: a growth of {{1 + c, s}, {s, 1 - c}}
times the command, c and s the anisotropy of the pump, to which an uneven gap adds that of its softening. Mechanism 37.</p>
</html>"));
end DriveErrors;
