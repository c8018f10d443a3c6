within HRG.Controls;
block WholeAngleReadout "Angle of the case from the angle of the pattern"
  parameter Units.Time samplePeriod "Period of the output";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.DimensionlessRatio bryanFactor(min = 0.01, max = 1) = 0.277 "Bryan factor that the electronics believe";
  parameter Units.DimensionlessRatio clockError(min = -1e-2, max = 1e-2) = 0
    "Relative excess of the electronics' clock, typically 1e-7 to 2e-5";
  parameter Units.DimensionlessRatio virtualRotationError(min = -0.1, max = 0.1) = 0
    "True over commanded rotation, less one, typically 1e-5 to 1e-3";
  parameter Units.Angle quantum(min = 0, max = 0.1) = 0
    "Least significant bit of the output angle, typically 5e-8 to 5e-6: 0.01 to 1 arcsec (estimate); 0: none";
  parameter Units.DimensionlessRatio ratePeriods "Periods over which the rate is taken: 2 where every second reading is old";
  input Units.Angle patternAngle "Detected pattern angle";
  input Units.Angle commandedAngle "Pattern angle at time 0 and all rotation counted since";
  input Units.AngularVelocity commandedRate "Pattern rate that is commanded";
  input Units.AngularVelocity lostRate "Share of it that drives could not give";
  input Units.DimensionlessRatio driveOn "Share of the command that is driven and counted";
  input Units.AngularVelocity unknownRate "Pattern rate that is driven and not counted";
  input Units.DimensionlessRatio gainNoise "Relative noise of the commanded rotation";
  input Units.Angle angleError "Calibrated error of the detected pattern angle";
  input Units.Angle correction "Integral of the calibrated bias";
  output Units.AngularVelocity patternRate "Pattern rate to be driven";
  output Units.AngularVelocity countedRate "Commanded rate as the gyro's clock integrates it";
  discrete output Units.Angle gyroAngle(start = 0, fixed = true)
    "Measured angle of the case since time 0; begins at the read-out's error";
  discrete output Units.AngularVelocity gyroRate(start = 0, fixed = true) "Measured rate of the case over the last periods";
protected
  discrete Units.Angle previous(start = 0, fixed = true) "Measured angle at the sample before; at the first one its own";
  discrete Units.DimensionlessRatio started(start = 0, fixed = true) "1 from the first sample on";
equation
  patternRate = commandedRate*(1 + virtualRotationError + gainNoise) + unknownRate;
  countedRate = (1 + clockError)*driveOn*(commandedRate - lostRate);
  when tick then
    gyroAngle = Electrodes.digitised((commandedAngle - (patternAngle - angleError))/bryanFactor - correction, quantum, 0);
    previous = if pre(started) > 0.5 then pre(gyroAngle) else gyroAngle;
    gyroRate = pre(started)*(gyroAngle - (if ratePeriods > 1.5 then pre(previous) else pre(gyroAngle)))/(ratePeriods*samplePeriod*(1 + clockError));
    started = 1;
  end when;
  annotation (Documentation(info="<html>
<p>The pattern lags the case: d theta/dt = -k Omega. What was commanded is taken out again, be it a virtual
rotation or the force that holds the pattern in the force-to-rebalance mode.</p>
</html>"));
end WholeAngleReadout;
