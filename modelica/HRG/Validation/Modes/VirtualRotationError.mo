within HRG.Validation.Modes;
model VirtualRotationError "Virtual rotation V with a gain error e: a bias of -e V"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.Angle,
    gyro(virtualRotation = rate, controller(readout(virtualRotationError = present*gainError))));
  parameter Units.AngularVelocity rate = 0.02 "V, as an input rate";
  parameter Units.DimensionlessRatio gainError = 1e-3 "e, true over commanded rotation, less one";
protected
  Units.Angle turned(start = 0, fixed = true) "Integral of V";
equation
  der(turned) = rate;
  measured = gyro.gyroAngle;
  expected = -gainError*turned;
  scale = abs(gainError*turned);
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>What is driven and not counted stays in the output: mechanism 18.</p>
</html>"));
end VirtualRotationError;
