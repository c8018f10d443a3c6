within HRG.Electrodes;
block Drive "Force as the shell feels it"
  parameter Units.Ratio gainMismatch(min = -0.5, max = 0.5) = 0 "gd: x drives (1 + gd/2) fx, y drives (1 - gd/2) fy";
  parameter Units.Ratio nonOrthogonality(min = -0.5, max = 0.5) = 0 "nd: y drives fy + nd fx";
  input Units.Force command[4] "Commanded force {cos x, sin x, cos y, sin y}";
  input Units.Force noise[4] "Force noise, thermomechanical noise included";
  output Units.Force force[4] "Force on the shell {cos x, sin x, cos y, sin y}";
protected
  final parameter Units.Ratio gainX = 1 + gainMismatch/2 "Gain of x";
  final parameter Units.Ratio gainY = 1 - gainMismatch/2 "Gain of y";
equation
  force = {
    gainX*command[1] + noise[1],
    gainX*command[2] + noise[2],
    gainY*(command[3] + nonOrthogonality*command[1]) + noise[3],
    gainY*(command[4] + nonOrthogonality*command[2]) + noise[4]};
  annotation (Documentation(info="<html>
<p>Non-orthogonality first, then gain.</p>
</html>"));
end Drive;
