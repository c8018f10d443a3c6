within HRG.Examples.BaseClasses;
block ThreeLoops "Electronics of one's own: loops of phase, amplitude and quadrature around a free pattern"
  extends Interfaces.PartialElectronics;
  parameter Units.DimensionlessRatio bryanFactor = 0.277 "Bryan factor that the electronics believe";
  Controls.PatternDetector detector(
    samplePeriod = samplePeriod,
    tick = tick,
    startAngle = startAngle,
    reading = reading,
    expected = 2*detector.lastAngle) "Orbit of the vibration";
  Controls.ProportionalIntegral phaseLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    naturalFrequency = 200,
    error = detector.phase + phaseOffset,
    frozen = 0) "Keeps the reference in phase with the antinode";
  Controls.ProportionalIntegral amplitudeLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    startCommand = startForce,
    error = driveOn*(amplitudeSetpoint - detector.amplitude),
    frozen = 0) "Holds the antinode amplitude";
  Controls.ProportionalIntegral quadratureLoop(
    samplePeriod = samplePeriod,
    tick = tick,
    error = -driveOn*detector.quadrature,
    frozen = 0) "Holds the quadrature at zero";
protected
  discrete Units.RelativeForce antinode(start = 0, fixed = true) "Force on the antinode";
  discrete Units.RelativeForce square(start = 0, fixed = true) "Force on the node in quadrature";
  discrete Units.RelativeForce command[4](each start = 0, each fixed = true) "Force {cos x, sin x, cos y, sin y}";
  discrete Units.RelativeForce last[4](each start = 0, each fixed = true) "Force of the period before";
  discrete Units.Angle angle(start = 0, fixed = true) "Angle of the case";
  discrete Units.AngularVelocity rate(start = 0, fixed = true) "Its rate over the last period";
equation
  when tick then
    antinode = driveOn*amplitudeLoop.command;
    square = driveOn*quadratureLoop.command;
    command = {antinode*detector.cosine, -square*detector.sine, antinode*detector.sine, square*detector.cosine};
    last = pre(command);
    angle = (startAngle - detector.patternAngle)/bryanFactor;
    rate = (angle - pre(angle))/samplePeriod;
  end when;
  force = command;
  acting = last;
  pump = 0;
  reference = phaseLoop.command;
  commandedTurn = 0;
  isHeld = 0;
  gyroAngle = angle;
  gyroRate = rate;
  patternAngle = detector.patternAngle;
  detectedAmplitude = detector.amplitude;
  detectedQuadrature = detector.quadrature;
  growthRate = antinode/detector.amplitude;
  quadratureForce = square;
  frequencyOffset = reference;
  valid = 1;
  annotation (Documentation(info="<html>
<p>What the tutorial on firmware does in C. No virtual rotation, no start-up, no compensation, no limit of the drives.</p>
</html>"));
end ThreeLoops;
