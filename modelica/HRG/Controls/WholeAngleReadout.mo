within HRG.Controls;
block WholeAngleReadout "Angle of the case from the angle of the pattern"
  parameter Units.Time samplePeriod "Control period";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.Ratio bryanFactor "Bryan factor that the electronics believe";
  input Units.Angle patternAngle "Detected pattern angle";
  input Units.AngularRate virtualRotation "Commanded virtual rotation, as an input rate";
  discrete output Units.AngularRate patternRate(start = 0, fixed = true) "Pattern rate to be driven until the next sample";
  discrete output Units.Angle gyroAngle(start = 0, fixed = true) "Measured angle of the case since time 0";
protected
  discrete Units.Angle commanded(start = startAngle, fixed = true) "Pattern angle at time 0 and all rotation commanded since";
equation
  when sample(0, samplePeriod) then
    commanded = pre(commanded) + samplePeriod*pre(patternRate);
    patternRate = bryanFactor*virtualRotation;
    gyroAngle = (commanded - patternAngle)/bryanFactor;
  end when;
  annotation (Documentation(info="<html>
<p>The pattern lags the case: d theta/dt = -k Omega. What was commanded is taken out again.</p>
</html>"));
end WholeAngleReadout;
