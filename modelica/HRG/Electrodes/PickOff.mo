within HRG.Electrodes;
block PickOff "Displacement as the electronics see it"
  parameter Units.Ratio gainMismatch(min = -0.5, max = 0.5) = 0
    "g: x reads (1 + g/2) x, y reads (1 - g/2) y; raw 1e-3 to 1e-2, calibrated 1e-5 to 1e-4";
  parameter Units.PerKelvin gainPerKelvin(min = -0.01, max = 0.01) = 0 "Change of g with temperature, typically 1e-6 to 1e-5";
  parameter Units.PerAcceleration gainPerAcceleration[3](each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of g with specific force (gap change), typically up to 1e-5";
  parameter Real gainPerAccelerationSquared[3](each unit = "s4/m2", each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of g with the square of specific force";
  parameter Units.Ratio nonOrthogonality(min = -0.5, max = 0.5) = 0 "d: y reads y + d x, typically 1e-4 to 2e-3 raw";
  parameter Real cubic(unit = "1", min = -1, max = 1) = 0
    "b: x reads x (1 + 3/4 b |x|^2), typically 1e-5 to 1e-3";
  parameter Units.Angle phaseError(min = -1, max = 1) = 0
    "p: phase that the demodulation adds to both channels, typically 1e-4 to 1e-2";
  parameter Real phasePerKelvin(unit = "rad/K", min = -0.01, max = 0.01) = 0 "Change of p with temperature, typically 1e-5 to 1e-4";
  parameter Units.Angle differentialPhase(min = -1, max = 1) = 0 "x turned by +p/2, y by -p/2, typically 1e-4 to 1e-3";
  parameter Units.Displacement offset(min = -1, max = 1) = 0 "Added to the in-phase x channel (ADC, demodulator), typically 1e-4";
  parameter Units.Time feedthrough(min = -1, max = 1) = 0 "Reads this time the force as well, typically 1e-6 to 1e-4";
  parameter Units.Displacement resolution(min = 0, max = 1) = 0 "Least significant bit of a channel; 0: none";
  parameter Units.Displacement fullScale(min = 0, max = 1e6) = 0 "A channel clips at this value; 0: never";
  input Units.Displacement displacement[4] "True displacement {cx, sx, cy, sy}";
  input Units.Force force[4] "Force in action at the moment of sampling";
  input Units.TemperatureDifference temperature "Above the reference";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  input Units.Displacement noise[4] "Noise of the demodulated channels";
  output Units.Displacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
protected
  Units.Ratio mismatch "g under temperature and specific force";
  Units.Angle phase "p under temperature";
  Units.Displacement y[2] "y with the share of x";
  Units.Ratio gainX "Gain of x, its nonlinearity included";
  Units.Ratio gainY "Gain of y, its nonlinearity included";
  Units.Ratio cosX "Of the phase of x";
  Units.Ratio sinX "Of the phase of x";
  Units.Ratio cosY "Of the phase of y";
  Units.Ratio sinY "Of the phase of y";
equation
  mismatch = gainMismatch + gainPerKelvin*temperature
    + gainPerAcceleration[1]*acceleration[1] + gainPerAcceleration[2]*acceleration[2]
    + gainPerAcceleration[3]*acceleration[3]
    + gainPerAccelerationSquared[1]*acceleration[1]^2 + gainPerAccelerationSquared[2]*acceleration[2]^2
    + gainPerAccelerationSquared[3]*acceleration[3]^2;
  phase = phaseError + phasePerKelvin*temperature;
  y = {displacement[3] + nonOrthogonality*displacement[1], displacement[4] + nonOrthogonality*displacement[2]};
  gainX = (1 + mismatch/2)*(1 + 0.75*cubic*(displacement[1]^2 + displacement[2]^2));
  gainY = (1 - mismatch/2)*(1 + 0.75*cubic*(y[1]^2 + y[2]^2));
  cosX = cos(phase + differentialPhase/2);
  sinX = sin(phase + differentialPhase/2);
  cosY = cos(phase - differentialPhase/2);
  sinY = sin(phase - differentialPhase/2);
  reading = {
    digitised(gainX*(cosX*displacement[1] + sinX*displacement[2]) + offset + feedthrough*force[1] + noise[1], resolution, fullScale),
    digitised(gainX*(cosX*displacement[2] - sinX*displacement[1]) + feedthrough*force[2] + noise[2], resolution, fullScale),
    digitised(gainY*(cosY*y[1] + sinY*y[2]) + feedthrough*force[3] + noise[3], resolution, fullScale),
    digitised(gainY*(cosY*y[2] - sinY*y[1]) + feedthrough*force[4] + noise[4], resolution, fullScale)};
  annotation (Documentation(info="<html>
<p>Non-orthogonality, cubic nonlinearity, gain, phase (the complex envelope cx - i sx times exp(i p)), then offset,
feedthrough, noise, and the converter: mechanisms 2, 4, 7, 10 to 13, 24, 28 and 30 of the catalogue.</p>
</html>"));
end PickOff;
