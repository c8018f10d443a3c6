within HRG.Examples;
model Turntable "A typical gyro on a table that turns once in a minute: what it measures, and its error"
  parameter Units.AngularVelocity rate = Constants.pi/30 "Rate of the table";
  output Units.Angle tableAngle(start = 0, fixed = true) "Angle of the table";
  output Units.Angle gyroAngle "Angle that the gyro measures";
  output Units.Angle error "Its error";
  output Units.Angle patternAngle "Pattern angle";
  BaseClasses.GyroAtRest gyro(
    angularRate = rate,
    seed = 1,
    resonator(material(dampingAnisotropy = 2e-6, dampingAxis = 0.35)),
    pickOff(gainMismatch = 1e-4),
    noise(angleRandomWalk = 1e-7)) "Gyro with damping anisotropy, a pick-off gain mismatch and force noise";
equation
  der(tableAngle) = rate;
  gyroAngle = gyro.gyroAngle;
  error = gyroAngle - tableAngle;
  patternAngle = gyro.patternAngle;
  annotation (experiment(StopTime = 60), Documentation(info="<html>
<p>While the table turns by 360 degrees, the pattern turns by -k of that, -99.7 degrees. The pick-off gain mismatch g makes
an error of (g/4k) sin 4 theta, which comes and goes with the pattern angle; damping anisotropy D adds a drift of
-(D/4k) sin 4(theta - theta_tau); force noise walks randomly.</p>
</html>"));
end Turntable;
