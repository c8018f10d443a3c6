within HRG.Resonators;
model Resonator "Vibrating shell: environment, material and envelope"
  parameter Units.Time samplePeriod "Control period";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  parameter Units.Displacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at time 0";
  parameter Real imbalanceX(unit = "s/m", min = -1e3, max = 1e3) = 0
    "Force on x over in-phase vibration of the case at the modal frequency (mass imbalance)";
  parameter Real imbalanceY(unit = "s/m", min = -1e3, max = 1e3) = 0 "Force on y, likewise";
  input Units.AngularRate angularRate "Inertial rate about the input axis";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  input Units.Temperature caseTemperature "Temperature of the case";
  input Units.Ratio biasVoltage "Electrode bias voltage over the nominal one";
  input Units.Acceleration vibration "Case vibration at the modal frequency, in phase with the reference";
  input Units.AngularFrequency reference "Frequency of the rotating frame above the nominal one";
  input Units.Force force[4] "Drive forces {cos x, sin x, cos y, sin y}";
  output Units.Displacement displacement[4] "In-phase and quadrature displacement {cx, sx, cy, sy}";
  Environment environment(samplePeriod = samplePeriod) "Temperature and age";
  Material material "Coefficients of the envelope's equation";
  Envelope envelope(startAngle = startAngle, startAmplitude = startAmplitude) "Motion";
equation
  environment.caseTemperature = caseTemperature;
  material.temperature = environment.temperature;
  material.age = environment.age;
  material.biasVoltage = biasVoltage;
  material.acceleration = acceleration;
  material.angularRate = angularRate;
  envelope.dampingX = material.dampingX;
  envelope.dampingY = material.dampingY;
  envelope.dampingSin = material.dampingSin;
  envelope.shift = material.shift;
  envelope.splitCos = material.splitCos;
  envelope.splitSin = material.splitSin;
  envelope.coupling = material.coupling;
  envelope.reference = reference;
  envelope.force = {
    force[1] + imbalanceX*vibration,
    force[2],
    force[3] + imbalanceY*vibration,
    force[4]};
  displacement = envelope.displacement;
end Resonator;
