within HRG.Validation.Modes;
model SweepSwing "Sweep of the pattern with errors of the electrodes: an angle that swings by ((g + gd) sin 4 theta - (d + nd) cos 4 theta)/8k"
  extends BaseClasses.Claim(
    tolerance = 0.01,
    redeclare type Quantity = Units.Angle,
    gyro(
      pickOff(gainMismatch = present*g, nonOrthogonality = present*d),
      drive(gainMismatch = present*gd, nonOrthogonality = present*nd),
      controller(parametricShare = 1, sweep(angle = Constants.pi/2, sweepTime = 5))));
  parameter Units.DimensionlessRatio g = 1e-3 "Gain mismatch of the pick-offs";
  parameter Units.DimensionlessRatio gd = 4e-4 "Gain mismatch of the drives";
  parameter Units.DimensionlessRatio d = 7e-4 "Non-orthogonality of the pick-offs";
  parameter Units.DimensionlessRatio nd = -2e-4 "Non-orthogonality of the drives";
protected
  Units.Angle swing "Of the output";
equation
  swing = ((g + gd)*(sin(4*theta) - sin(4*startAngle)) - (d + nd)*(cos(4*theta) - cos(4*startAngle)))/(8*k);
  measured = gyro.gyroAngle;
  expected = (g*sin(4*startAngle) - d*(1 + cos(4*startAngle)))/(4*k) + swing;
  scale = (g + gd)/(8*k);
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>Forces meant to turn the pattern at k V turn it at k V (1 + ((g - gd)/2) cos 4 theta + ((d - nd)/2) sin 4 theta), and the pick-offs
show that times 1 - g cos 4 theta - d sin 4 theta: the rate of the output is ((g + gd)/2) V cos 4 theta + ((d + nd)/2) V sin 4 theta.
Its integral begins where the pick-offs misread the start angle. Mechanisms 2 to 5. Parametric drive takes
out what the amplitude force would add.</p>
</html>"));
end SweepSwing;
