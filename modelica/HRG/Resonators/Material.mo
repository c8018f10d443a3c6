within HRG.Resonators;
block Material "Damping, stiffness and coupling of the shell under its environment"
  parameter Units.Time decayTime(min = 1, max = 1e5) = 450 "Mean amplitude decay time tau, typically 200 to 2000 s";
  parameter Units.LinearTemperatureCoefficient decayTimePerKelvin(min = -0.1, max = 0.1) = 0 "Of the decay time, typically -0.002 to -0.01";
  parameter Real decayTimeAgeing(unit = "1/s", min = -1e-4, max = 1e-4) = 0
    "Relative loss of decay time per time (outgassing, vacuum loss), typically 1 to 5 % a year";
  parameter Units.DampingCoefficient dampingAnisotropy(min = 0, max = 1e-2) = 0
    "D = 1/tau1 - 1/tau2 between the axes of maximum and minimum damping, typically 0.1 to 2 % of 1/tau";
  parameter Units.Angle dampingAxis(min = -1000, max = 1000) = 0 "Pattern angle of maximum damping";
  parameter Units.LinearTemperatureCoefficient dampingAnisotropyPerKelvin(min = -1, max = 1) = 0 "Of the damping anisotropy, typically up to 0.01";
  parameter Real dampingAnisotropyAgeing(unit = "1/s", min = -1e-4, max = 1e-4) = 0
    "Relative growth of the damping anisotropy with age, typically 1e-10 to 1e-8: 0.3 to 30 % a year (estimate)";
  parameter Units.DampingCoefficient mountingDamping(min = 0, max = 1e-2) = 0
    "Damping anisotropy that the mounting adds (anchor loss), changes with remounting and shock, typically up to the shell's own, 0.1 to 2 % of 1/tau";
  parameter Units.Angle mountingAxis(min = -1000, max = 1000) = 0 "Its pattern angle of maximum damping";
  parameter Units.AngularFrequency frequency(min = 1e3, max = 1e6) = 43982.297150257104 "Nominal modal frequency, 4 to 9 kHz";
  parameter Units.LinearTemperatureCoefficient frequencyPerKelvin(min = -1e-3, max = 1e-3) = 0 "Of the modal frequency, typically 80e-6 to 95e-6";
  parameter Units.AngularFrequency frequencySplit(min = 0, max = 100) = 0
    "Difference of the modes' circular frequencies, typically 0.06 to 3 raw (10 to 500 mHz), below 6e-3 trimmed (1 mHz)";
  parameter Units.Angle stiffnessAxis(min = -1000, max = 1000) = 0 "Pattern angle of the mode of lower frequency";
  parameter Units.AngularFrequency duffing(min = -100, max = 100) = 0
    "Frequency shift at unit amplitude by cubic stiffness, typically 1e-6 of the frequency";
  parameter Real splitPerAcceleration[3](each unit = "rad.s/m", each min = -10, each max = 10) = {0, 0, 0}
    "Frequency split with its axis along the x electrodes, per specific force, typically 5e-7 to 1e-5: with a phase error of 1e-3 a bias of 1e-3 to 2e-2 deg/h/g";
  parameter Units.AngularFrequency electrostaticShift(min = -1e3, max = 1e3) = 0
    "Softening of the mean frequency by the nominal bias voltage, typically 0.3 to 30: a drift of 0.01 to 1 mHz for a voltage off by 1e-4";
  parameter Units.AngularFrequency electrostaticSplit(min = 0, max = 100) = 0
    "Frequency split that the nominal bias voltage makes (trim), balanced by the mechanical one, typically 0.06 to 3: the raw split of 10 to 500 mHz";
  parameter Units.Angle electrostaticAxis(min = -1000, max = 1000) = 0 "Pattern angle of its lower frequency";
  parameter Units.AngularFrequency electrostaticCubic(min = -100, max = 100) = 0
    "Softening of x and of y at unit amplitude of their own by eight electrodes under the nominal bias voltage, typically 1e-3 to 0.1: 3/2 of electrostaticShift times the square of amplitude over gap";
  parameter Units.DimensionlessRatio bryanFactor(min = 0.01, max = 1) = 0.277 "Precession of the pattern over rotation of the case";
  parameter Units.LinearTemperatureCoefficient bryanFactorPerKelvin(min = -1e-3, max = 1e-3) = 0 "Of the Bryan factor, typically below 1e-6";
  parameter Units.DampingCoefficient supportLoss "Mean damping by the support";
  parameter Units.DampingCoefficient supportCos "Anisotropic damping by the support, diagonal";
  parameter Units.DampingCoefficient supportSin "Anisotropic damping by the support, off diagonal";
  parameter Units.DimensionlessRatio ringErrors[9] "Errors of the electrode ring, as of Electrodes.ringErrors";
  input Units.TemperatureDifference temperature "Above the reference";
  input Units.Time age "Time since power-on";
  input Units.DimensionlessRatio dampingFlicker "Relative change of the damping anisotropy by its flicker";
  input Units.DimensionlessRatio isDecaying "1 with damping, 0 without";
  input Units.DimensionlessRatio biasVoltage "Over the nominal one";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  input Units.AngularVelocity angularRate "Inertial rate about the input axis";
  output Units.DampingCoefficient dampingX "Damping of x";
  output Units.DampingCoefficient dampingY "Damping of y";
  output Units.DampingCoefficient dampingSin "Damping between x and y";
  output Units.AngularFrequency shift "Mean frequency above the nominal one";
  output Units.AngularFrequency splitCos "Stiffness anisotropy, diagonal";
  output Units.AngularFrequency splitSin "Stiffness anisotropy, off diagonal";
  output Units.AngularFrequency cubic "Softening of x and of y at unit amplitude of their own";
  output Units.AngularVelocity coupling "Bryan coupling of the modes, n k Omega with n = 2";
protected
  final parameter Units.DampingCoefficient ownCos = dampingAnisotropy/2*cos(4*dampingAxis) "Of the shell, diagonal";
  final parameter Units.DampingCoefficient ownSin = dampingAnisotropy/2*sin(4*dampingAxis) "Of the shell, off diagonal";
  final parameter Units.DampingCoefficient mountingCos = mountingDamping/2*cos(4*mountingAxis) + supportCos "Of the mounting and the support, diagonal";
  final parameter Units.DampingCoefficient mountingSin = mountingDamping/2*sin(4*mountingAxis) + supportSin "Of the mounting and the support, off diagonal";
  final parameter Units.AngularFrequency ownSplitCos = frequencySplit/2*cos(4*stiffnessAxis) "Of the shell, diagonal";
  final parameter Units.AngularFrequency ownSplitSin = frequencySplit/2*sin(4*stiffnessAxis) "Of the shell, off diagonal";
  final parameter Units.AngularFrequency trimCos = electrostaticSplit/2*cos(4*electrostaticAxis) + electrostaticShift*ringErrors[8] "Of the trim and the gap, diagonal";
  final parameter Units.AngularFrequency trimSin = electrostaticSplit/2*sin(4*electrostaticAxis) + electrostaticShift*ringErrors[9] "Of the trim and the gap, off diagonal";
  Units.DampingCoefficient damping "Mean damping";
  Units.DampingCoefficient dampingCos "Anisotropic damping, diagonal";
  Units.DimensionlessRatio warmth "Factor of the damping anisotropy by temperature, age and flicker";
  Units.DimensionlessRatio voltageChange "Change of the squared bias voltage";
equation
  damping = exp(decayTimeAgeing*age)/(decayTime*stretched(decayTimePerKelvin*temperature)) + supportLoss;
  warmth = 1 + dampingAnisotropyPerKelvin*temperature + dampingAnisotropyAgeing*age + dampingFlicker;
  dampingCos = ownCos*warmth + mountingCos;
  dampingSin = isDecaying*(ownSin*warmth + mountingSin);
  dampingX = isDecaying*(damping + dampingCos);
  dampingY = isDecaying*(damping - dampingCos);
  voltageChange = biasVoltage*biasVoltage - 1;
  shift = frequency*frequencyPerKelvin*temperature - electrostaticShift*voltageChange;
  splitCos = ownSplitCos + trimCos*voltageChange
    + (splitPerAcceleration[1]*acceleration[1] + splitPerAcceleration[2]*acceleration[2]
    + splitPerAcceleration[3]*acceleration[3])/2;
  splitSin = ownSplitSin + trimSin*voltageChange;
  cubic = electrostaticCubic*biasVoltage*biasVoltage;
  coupling = 2*bryanFactor*(1 + bryanFactorPerKelvin*temperature)*angularRate;
  annotation (Documentation(info="<html>
<p>With T the temperature above the reference, V the bias voltage over the nominal one, f the specific force and {c, s} = {cos, sin} of four
times an axis,</p>
<pre>1/tau = exp(decayTimeAgeing age)/(decayTime (1 + decayTimePerKelvin T)) + supportLoss
(D/2) {ct, st} = (dampingAnisotropy/2)(1 + dampingAnisotropyPerKelvin T + dampingAnisotropyAgeing age + flicker) {c, s} + (mountingDamping/2) {c, s}
(dw/2) {cw, sw} = (frequencySplit/2) {c, s} + (electrostaticSplit/2)(V^2 - 1) {c, s} + (splitPerAcceleration f/2) {1, 0}
frequency of x, y lower by electrostaticCubic V^2 |X|^2, electrostaticCubic V^2 |Y|^2
mean frequency = frequency (1 + frequencyPerKelvin T) - electrostaticShift (V^2 - 1)
k = bryanFactor (1 + bryanFactorPerKelvin T)</pre>
<p>A decay time would be below half at decayTimePerKelvin T &lt; -1/2: there <code>stretched</code> keeps it above zero.</p>
<p>A fourth harmonic of the gap (<code>Electrodes.Ring</code>) adds electrostaticShift (V^2 - 1) times its share to the anisotropy. Mechanisms 1, 9, 14, 16, 23 to 26, 28, 31 to 33, 35 and 38 of the catalogue: what slowly changes the coefficients of the
motion. At the nominal bias voltage the electrostatic terms are part of the nominal values.</p>
</html>"));
end Material;
