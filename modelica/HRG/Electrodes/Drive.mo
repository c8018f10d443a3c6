within HRG.Electrodes;
block Drive "Force as the shell feels it"
  extends DriveErrors;
  input Units.Force command[4] "Commanded force {cos x, sin x, cos y, sin y}";
  input Units.Force noise[4] "Force noise, thermomechanical noise included";
  output Units.Force force[4] "Force on the shell {cos x, sin x, cos y, sin y}";
protected
  Units.Force bounded[4] "Command within the drive's authority";
equation
  bounded = {
    digitised(command[1], 0, authority),
    digitised(command[2], 0, authority),
    digitised(command[3], 0, authority),
    digitised(command[4], 0, authority)};
  force = {
    gain[1]*bounded[1] + gain[2]*bounded[3] + noise[1],
    gain[1]*bounded[2] + gain[2]*bounded[4] + noise[2],
    gain[3]*bounded[1] + gain[4]*bounded[3] + noise[3],
    gain[3]*bounded[2] + gain[4]*bounded[4] + noise[4]};
end Drive;
