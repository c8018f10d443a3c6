within HRG.Validation.PickOffs;
model FullScale "Converter full scale f: the angle read is that of the clipped displacements"
  extends BaseClasses.Claim(redeclare type Quantity = Units.Angle, gyro(pickOff(fullScale = present*limit)));
  parameter Units.RelativeDisplacement limit = 0.8 "f, over the amplitude";
protected
  Units.RelativeDisplacement x "Read";
  Units.RelativeDisplacement y "Read";
equation
  measured = (startAngle - theta)/k;
  x = (if cos(2*startAngle) > limit then limit elseif cos(2*startAngle) < -limit then -limit else cos(2*startAngle));
  y = (if sin(2*startAngle) > limit then limit elseif sin(2*startAngle) < -limit then -limit else sin(2*startAngle));
  expected = atan2(sin(2*startAngle)*x - cos(2*startAngle)*y, cos(2*startAngle)*x + sin(2*startAngle)*y)/(2*k);
  scale = (1 - limit)/(8*k);
  annotation (experiment(StopTime = 0.0005), Documentation(info="<html>
<p>At power-on x = cos 2 theta and y = sin 2 theta are known; the angle read is (1/2) atan2 of both clipped at f.
Mechanism 30.</p>
<p>The claim is of the first sample, before the loops act on what they misread.</p>
</html>"));
end FullScale;
