within HRG.Examples;
model VirtualRotation "A gyro at rest whose pattern is turned: its bias goes round with the pattern and averages out"
  parameter Units.AngularVelocity rotation = 0.1 "Commanded virtual rotation, as an input rate";
  output Units.Angle patternAngle "Pattern angle";
  output Units.Angle gyroAngle "Angle measured with the pattern turning";
  output Units.Angle restingAngle "Angle measured with the pattern at rest";
  BaseClasses.GyroAtRest turning(
    virtualRotation = rotation,
    startAngle = 0.3,
    resonator(material(dampingAnisotropy = 1e-5))) "Its pattern turns";
  BaseClasses.GyroAtRest resting(
    startAngle = 0.3,
    resonator(material(dampingAnisotropy = 1e-5))) "Its pattern stands";
equation
  patternAngle = turning.patternAngle;
  gyroAngle = turning.gyroAngle;
  restingAngle = resting.gyroAngle;
  annotation (experiment(StopTime = 120), Documentation(info="<html>
<p>Standing, the pattern has one bias, -(D/4k) sin 4(theta - theta_tau), which the angle gathers. Turned at k V it passes
through all of them, and the angle gathered is bounded by D/(8 k^2 V).</p>
</html>"));
end VirtualRotation;
