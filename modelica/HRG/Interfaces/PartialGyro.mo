within HRG.Interfaces;
partial model PartialGyro "Inputs, outputs and power-on of a gyro, alike in all fidelities"
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of all noise";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0 "Pattern angle at power-on";
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at power-on";
  input Units.AngularVelocity angularRate(start = 0, min = -100, max = 100, nominal = 0.1) "Inertial rate about the input axis";
  input Units.AngularVelocity virtualRotation(start = 0, min = -10, max = 10, nominal = 0.1) "Commanded virtual rotation, as an input rate";
  input Units.Acceleration accelerationX(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the x electrodes";
  input Units.Acceleration accelerationY(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force across the x electrodes";
  input Units.Acceleration accelerationZ(start = 0, min = -1e5, max = 1e5, nominal = 10) "Specific force along the input axis";
  input Units.Temperature caseTemperature(start = 298.15, min = 100, max = 500, nominal = 300) "Temperature of the case";
  input Units.DimensionlessRatio biasVoltage(start = 1, min = 0, max = 10, nominal = 1) "Electrode bias voltage over the nominal one";
  input Units.Acceleration vibration(start = 0, min = -1e5, max = 1e5, nominal = 1) "Case vibration at the modal frequency, in phase";
  input Units.RelativeDisplacement amplitudeSetpoint(start = 1, min = 0.01, max = 10, nominal = 1) "Antinode amplitude to hold";
  input Units.Angle phaseOffset(start = 0, min = -1, max = 1, nominal = 1e-2) "Added to the detected phase";
  input Units.Switch driveOn(start = 1, min = 0, max = 1, nominal = 1) "1 with the drive on, 0 off: ring-down";
  output Units.Angle gyroAngle(nominal = 1) "Measured angle about the input axis since power-on";
  output Units.AngularVelocity gyroRate(nominal = 0.1) "Measured rate over the last control period";
  output Units.Angle patternAngle(nominal = 1) "Detected pattern angle, continuous";
  output Units.RelativeDisplacement amplitude(min = 0, nominal = 1) "Detected antinode amplitude";
  output Units.RelativeDisplacement quadrature(nominal = 1e-3) "Detected quadrature amplitude";
  output Units.DampingCoefficient amplitudeForce(nominal = 2e-3) "Amplitude-loop force over detected amplitude, as a growth rate";
  output Units.RelativeForce quadratureForce(nominal = 1e-3) "Quadrature-loop force";
  output Units.AngularFrequency frequencyOffset(nominal = 1e-2) "Phase-loop frequency less the nominal one, as the gyro's clock counts it";
  output Units.Switch valid(min = 0, max = 1, nominal = 1) "1 while the output is valid";
  annotation (Documentation(info="<html>
<p>What every fidelity shows. Rates are input rates: a virtual rotation V turns the pattern at k V. All forces are growths of
the envelope, in 1/s: <code>amplitudeForce</code> at rest is the mean damping, 1/tau.</p>
</html>"));
end PartialGyro;
