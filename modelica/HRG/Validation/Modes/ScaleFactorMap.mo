within HRG.Validation.Modes;
model ScaleFactorMap "Compensation of the detected angle: the output takes the map over k, in every harmonic"
  extends BaseClasses.Turning(
    gyro(controller(scaleFactorMap(
      cos2 = 0.3*present*size,
      sin2 = -0.4*present*size,
      cos4 = 0.8*present*size,
      sin4 = 0.6*present*size,
      cos8 = -0.1*present*size,
      sin8 = 0.2*present*size))));
  parameter Units.Angle size = 1e-3 "Of the fourth harmonic";
equation
  measured = angleError;
  expected = size/k*(0.3*cos(2*theta) - 0.4*sin(2*theta) + 0.8*cos(4*theta) + 0.6*sin(4*theta)
    - 0.1*cos(8*theta) + 0.2*sin(8*theta));
  scale = size/k;
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>What the map holds to be the error e of the detected angle is taken out of it: the output, -theta/k, gains e/k.</p>
</html>"));
end ScaleFactorMap;
