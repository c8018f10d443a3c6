within HRG.Controls;
block WholeAngleReadout "Angle of the case from the angle of the pattern"
  parameter Units.Time samplePeriod "Control period";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.Ratio bryanFactor(min = 0.01, max = 1) = 0.277 "Bryan factor that the electronics believe";
  parameter Units.Ratio clockError(min = -1e-2, max = 1e-2) = 0
    "Relative excess of the electronics' clock, typically 1e-7 to 2e-5";
  parameter Units.Ratio virtualRotationError(min = -0.1, max = 0.1) = 0
    "True over commanded rotation, less one, typically 1e-5 to 1e-3";
  input Units.Angle patternAngle "Detected pattern angle";
  input Units.AngularRate commandedRate "Pattern rate that is commanded and known";
  input Units.AngularRate unknownRate "Pattern rate that is driven and not counted";
  input Units.Ratio gainNoise "Relative noise of the commanded rotation";
  input Units.Angle correction "Integral of the calibrated bias";
  discrete output Units.AngularRate patternRate(start = 0, fixed = true) "Pattern rate to be driven until the next sample";
  discrete output Units.Angle gyroAngle(start = 0, fixed = true) "Measured angle of the case since time 0";
  discrete output Units.AngularRate gyroRate(start = 0, fixed = true) "Measured rate of the case over the last period";
protected
  discrete Units.Angle commanded(start = startAngle, fixed = true) "Pattern angle at time 0 and all rotation commanded since";
  discrete Units.AngularRate counted(start = 0, fixed = true) "Commanded pattern rate";
equation
  when sample(0, samplePeriod) then
    commanded = pre(commanded) + samplePeriod*(1 + clockError)*pre(counted);
    counted = commandedRate;
    patternRate = counted*(1 + virtualRotationError + gainNoise) + unknownRate;
    gyroAngle = (commanded - patternAngle)/bryanFactor - correction;
    gyroRate = (gyroAngle - pre(gyroAngle))/(samplePeriod*(1 + clockError));
  end when;
  annotation (Documentation(info="<html>
<p>The pattern lags the case: d theta/dt = -k Omega. What was commanded is taken out again, be it a virtual
rotation or the force that holds the pattern in the force-to-rebalance mode.</p>
</html>"));
end WholeAngleReadout;
