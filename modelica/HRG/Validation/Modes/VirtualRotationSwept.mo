within HRG.Validation.Modes;
model VirtualRotationSwept "Virtual rotation swept as a sine: the gain error leaves -(e V/w)(1 - cos w t)"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.Angle,
    gyro(
      virtualRotation = rate*sin(sweep*clock),
      controller(readout(virtualRotationError = present*gainError))));
  parameter Units.AngularVelocity rate = 0.02 "V, as an input rate";
  parameter Units.DimensionlessRatio gainError = 1e-3 "e, true over commanded rotation, less one";
  parameter Units.AngularFrequency sweep = 0.5 "w, of the sweep";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = gyro.gyroAngle;
  expected = -gainError*rate/sweep*(1 - cos(sweep*clock));
  scale = gainError*rate/sweep;
  annotation (experiment(StopTime = 8), Documentation(info="<html>
<p>The integral of -e V sin w t. Mechanism 18.</p>
</html>"));
end VirtualRotationSwept;
