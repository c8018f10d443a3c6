within HRG.Electrodes;
block Drive "Force as the shell feels it"
  extends DriveErrors;
  Interfaces.Inputs.RelativeForce command[4] "Commanded force {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{-120, -85}, {-100, -65}})));
  Interfaces.Inputs.DampingCoefficient pump "Commanded growth by parametric drive"
    annotation (Placement(transformation(extent = {{-120, -35}, {-100, -15}})));
  Interfaces.Inputs.RelativeForce noise[4] "Force noise, thermomechanical noise included"
    annotation (Placement(transformation(extent = {{-120, 15}, {-100, 35}})));
  Interfaces.Outputs.RelativeForce force[4] "Force on the shell {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{100, -60}, {120, -40}})));
  Interfaces.Outputs.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them"
    annotation (Placement(transformation(extent = {{100, 40}, {120, 60}})));
equation
  force = {
    gain[1]*command[1] + gain[2]*command[3] + noise[1],
    gain[1]*command[2] + gain[2]*command[4] + noise[2],
    gain[3]*command[1] + gain[4]*command[3] + noise[3],
    gain[3]*command[2] + gain[4]*command[4] + noise[4]};
  pumping = {pump*pumpGain[1], pump*pumpGain[2], pump*pumpGain[3]};
  annotation (Documentation(info="<html>
<p>{fx, fy} = G {command} + noise, for the parts in phase and in quadrature alike; G is the gain of
<code>DriveErrors</code>. The electronics keep the command of each channel within the authority.</p>
</html>"));
end Drive;
