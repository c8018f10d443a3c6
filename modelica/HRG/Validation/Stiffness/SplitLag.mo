within HRG.Validation.Stiffness;
model SplitLag "Frequency split dw in a turning case: the quadrature loop lags, a scale factor of -(dw/w)^2 (1 + cos 8(theta - theta_w))/2"
  extends BaseClasses.Turning(
    redeclare final model Gyro = Gyroscopes.HRGEnvelope,
    tolerance = 0.005,
    rate = 0.1,
    gyro(
      resonator(material(frequencySplit = present*split, stiffnessAxis = axis)),
      controller(quadratureLoop(naturalFrequency = bandwidth))));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-2 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
  parameter Units.AngularFrequency bandwidth = 6 "w, natural frequency of the quadrature loop";
equation
  measured = angleError;
  expected = (split/bandwidth)^2*(
    (sin(8*(theta - axis)) + sin(8*(startAngle - axis)))/(16*k) - caseAngle/2 + 2*rate/bandwidth);
  scale = (split/bandwidth)^2*caseAngle/2;
  annotation (experiment(StopTime = 60), Documentation(info="<html>
<p>The split drives quadrature at -(dw/2) a sin 4(theta - theta_w), which turns with the pattern. A loop with both poles at w
leaves its derivative over w^2: q/a = 2 k W dw cos 4(theta - theta_w)/w^2 while 4 k W is far below w. By mechanism 8 that is a
rate error of -W (dw/w)^2 (1 + cos 8(theta - theta_w))/2: mechanism 9. The angle is its integral, and what the loop's start
from zero adds, (dw/w)^2 (sin 8(theta_0 - theta_w)/8k + 2 W/w). <code>HRGSlow</code>, whose loops don't lag, has none of it.</p>
</html>"));
end SplitLag;
