within HRG.Validation.PickOffs;
model Resolution "Converter resolution r: the angle read is that of the rounded displacements"
  extends BaseClasses.Claim(redeclare type Quantity = Units.Angle, gyro(pickOff(resolution = present*step)));
  parameter Units.RelativeDisplacement step = 1e-2 "r, over the amplitude";
protected
  Units.RelativeDisplacement x "Read";
  Units.RelativeDisplacement y "Read";
equation
  measured = (startAngle - theta)/k;
  x = step*floor(cos(2*startAngle)/step + 0.5);
  y = step*floor(sin(2*startAngle)/step + 0.5);
  expected = atan2(sin(2*startAngle)*x - cos(2*startAngle)*y, cos(2*startAngle)*x + sin(2*startAngle)*y)/(2*k);
  scale = step/(4*k);
  annotation (experiment(StopTime = 0.0005), Documentation(info="<html>
<p>At power-on x = cos 2 theta and y = sin 2 theta are known; the angle read is (1/2) atan2 of both rounded to r.
Mechanism 30.</p>
<p>The claim is of the first sample, before the loops act on what they misread.</p>
</html>"));
end Resolution;
