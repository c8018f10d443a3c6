within HRG.Examples;
model ReplacedElectronics "The gyro with electronics of one's own, on a table, beside the gyro with its own"
  parameter Units.AngularVelocity rate = 0.1 "Rate of the table";
  output Units.Angle gyroAngle "Angle measured with the electronics put in";
  output Units.Angle usualAngle "Angle measured with the usual ones";
  output Units.Angle difference "What they differ by";
  BaseClasses.GyroAtRest gyro(
    redeclare BaseClasses.ThreeLoops controller(quadratureLoop(naturalFrequency = 2)),
    angularRate = rate,
    resonator(material(dampingAnisotropy = 1e-5, frequencySplit = 0.01))) "Gyro with three loops, that of the quadrature slow";
  BaseClasses.GyroAtRest usual(
    angularRate = rate,
    resonator(material(dampingAnisotropy = 1e-5, frequencySplit = 0.01))) "The same gyro with the library's electronics";
equation
  gyroAngle = gyro.gyroAngle;
  usualAngle = usual.gyroAngle;
  difference = gyroAngle - usualAngle;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>Any block that extends <code>Interfaces.PartialElectronics</code> takes the place of <code>Controls.Controller</code> by one redeclaration. In a
gyro of one's own, exported by <code>hrg build --class</code>, it is the same line. With the usual natural frequency of the quadrature loop, 6 rad/s, both gyros would show the same
angle; the slow loop leaves more quadrature under the frequency split, and with it more error.</p>
</html>"));
end ReplacedElectronics;
