within HRG.Electrodes;
block Drive "Force as the shell feels it"
  parameter Units.Angle frameRotation(min = -0.5, max = 0.5) = 0
    "e: drive electrodes turned against the pick-offs, on the modal axes, typically 1e-4 to 2e-3 raw";
  parameter Real rotationPerAcceleration[3](each unit = "rad.s2/m", each min = -0.01, each max = 0.01) = {0, 0, 0}
    "Change of e with specific force; a bias of -1/(2 k tau) times it";
  parameter Real rotationPerTemperatureRate(unit = "rad.s/K", min = -1e3, max = 1e3) = 0
    "Change of e with the rate of the case's temperature (gradients), likewise";
  parameter Units.Ratio nonOrthogonality(min = -0.5, max = 0.5) = 0 "nd: y drives fy + nd fx, typically 1e-4 to 2e-3 raw";
  parameter Units.Ratio gainMismatch(min = -0.5, max = 0.5) = 0
    "gd: x drives (1 + gd/2) fx, y drives (1 - gd/2) fy; raw 1e-3 to 1e-2, calibrated 1e-5 to 1e-4";
  parameter Units.Force authority(min = 0, max = 1e6) = 0 "A channel clips at this force; 0: never";
  input Units.Force command[4] "Commanded force {cos x, sin x, cos y, sin y}";
  input Units.Acceleration acceleration[3] "Specific force, z along the input axis";
  input Real temperatureRate(unit = "K/s") "Rate of the case's temperature";
  input Units.Force noise[4] "Force noise, thermomechanical noise included";
  output Units.Force force[4] "Force on the shell {cos x, sin x, cos y, sin y}";
protected
  final parameter Units.Ratio gainX = 1 + gainMismatch/2 "Gain of x";
  final parameter Units.Ratio gainY = 1 - gainMismatch/2 "Gain of y";
  Units.Angle rotation "e under specific force and gradients";
  Units.Ratio cosine "Of e";
  Units.Ratio sine "Of e";
  Units.Force bounded[4] "Command within the drive's authority";
  Units.Force turned[4] "Command in the turned frame";
equation
  rotation = frameRotation + rotationPerTemperatureRate*temperatureRate
    + rotationPerAcceleration[1]*acceleration[1] + rotationPerAcceleration[2]*acceleration[2]
    + rotationPerAcceleration[3]*acceleration[3];
  cosine = cos(rotation);
  sine = sin(rotation);
  bounded = {
    digitised(command[1], 0, authority),
    digitised(command[2], 0, authority),
    digitised(command[3], 0, authority),
    digitised(command[4], 0, authority)};
  turned = {
    cosine*bounded[1] - sine*bounded[3],
    cosine*bounded[2] - sine*bounded[4],
    sine*bounded[1] + cosine*bounded[3],
    sine*bounded[2] + cosine*bounded[4]};
  force = {
    gainX*turned[1] + noise[1],
    gainX*turned[2] + noise[2],
    gainY*(turned[3] + nonOrthogonality*turned[1]) + noise[3],
    gainY*(turned[4] + nonOrthogonality*turned[2]) + noise[4]};
  annotation (Documentation(info="<html>
<p>Authority, frame rotation, non-orthogonality, then gain: mechanisms 3, 5, 6, 24, 28 and 30 of the catalogue.</p>
</html>"));
end Drive;
