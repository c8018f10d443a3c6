within HRG.Examples;
model RingDown "The drive is off: amplitude decays, and damping anisotropy turns the pattern"
  output Units.RelativeDisplacement amplitude "Antinode amplitude";
  output Units.Angle patternAngle "Pattern angle";
  BaseClasses.GyroAtRest gyro(
    driveOn = 0,
    startAngle = 0.3,
    resonator(material(dampingAnisotropy = 1e-4))) "Gyro that only listens";
equation
  amplitude = gyro.amplitude;
  patternAngle = gyro.patternAngle;
  annotation (experiment(StopTime = 300), Documentation(info="<html>
<p>The amplitude falls as exp(-t/tau), tau = 450 s, a little faster near the axis of maximum damping, here at 0;
tan 2(theta - theta_tau) grows as exp(D t), so that the pattern leaves that axis. The classical test for decay
time and damping anisotropy, free of any drive error.</p>
</html>"));
end RingDown;
