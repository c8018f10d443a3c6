within HRG.Validation.Modes;
model SweepGainError "Sweep of the pattern with a gain error e of the rotation: an angle of -e times the position over k"
  extends BaseClasses.Claim(
    tolerance = 0.005,
    redeclare type Quantity = Units.Angle,
    gyro(controller(
      sweep(angle = position, sweepTime = 5, restTime = 10),
      readout(virtualRotationError = present*gainError))));
  parameter Units.Angle position = Constants.pi/4 "Theta, of the far end";
  parameter Units.DimensionlessRatio gainError = 1e-3 "e, true over commanded rotation, less one";
equation
  measured = gyro.gyroAngle;
  expected = -gainError*position/k;
  scale = gainError*position/k;
  annotation (experiment(StopTime = 15), Documentation(info="<html>
<p>As of any commanded rotation; the way back takes it away. Mechanism 18.</p>
</html>"));
end SweepGainError;
