within HRG.Validation.Modes;
model VirtualRotation "Virtual rotation V turns the pattern at k V"
  extends BaseClasses.Claim(redeclare type Quantity = Units.Angle, gyro(virtualRotation = present*rate));
  parameter Units.AngularVelocity rate = 0.02 "V, as an input rate";
protected
  Units.Angle turned(start = 0, fixed = true) "Integral of V";
equation
  der(turned) = rate;
  measured = theta - startAngle;
  expected = k*turned;
  scale = k*abs(turned);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>theta = theta_0 + k V t, as if the case had turned at -V.</p>
</html>"));
end VirtualRotation;
