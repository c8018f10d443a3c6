within HRG.Validation.Modes;
model VirtualRotationReversing "Virtual rotation that reverses: the bias of its gain error reverses with it, and cancels over a cycle"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.Angle,
    gyro(virtualRotation = command.rate, controller(readout(virtualRotationError = present*gainError))));
  parameter Units.AngularVelocity rate = 0.02 "V, as an input rate";
  parameter Units.DimensionlessRatio gainError = 1e-3 "e, true over commanded rotation, less one";
  BaseClasses.Command command(samplePeriod = gyro.samplePeriod, size = rate, reversal = reversal) "Reversing rotation";
  parameter Units.Time reversal = 8 "Between changes of direction";
protected
  Units.Time clock(start = 0, fixed = true) "Time";
equation
  der(clock) = 1;
  measured = gyro.gyroAngle;
  expected = -gainError*rate*(2*reversal - clock);
  scale = gainError*rate*reversal;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>Forwards for T, then back: at T &lt; t &lt; 3 T the angle gained is -e V (2 T - t), which is zero at the end of the
cycle. Mechanism 18.</p>
</html>"));
end VirtualRotationReversing;
