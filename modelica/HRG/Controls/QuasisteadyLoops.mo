within HRG.Controls;
block QuasisteadyLoops "Loops that follow at once, and the forces they need"
  parameter Units.Time samplePeriod "Period of the output: loops come to rest within a few";
  final parameter Units.Time controlPeriod = 1e-3 "Control period of the electronics, which hold their forces for it";
  parameter Units.Time loopDelay(min = 0, max = 0.1) = 0
    "Age of the angle that forces are resolved with, beyond the sample, typically up to 1e-3";
  input Real freeRates[4] "Rates of the displacement without drive, {cx, sx, cy, sy}";
  input Units.RelativeDisplacement amplitude "True antinode amplitude";
  input Units.RelativeDisplacement quadrature "True quadrature";
  input Units.Angle phase "True phase against the reference";
  input Units.Angle modalAngle "True modal angle";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.AngularVelocity coupling "Bryan coupling 2 k Omega: minus the modal rate of a free pattern";
  input Units.RelativeDisplacement analogue[4] "Reading before noise and conversion";
  input Units.DimensionlessRatio driveGain[4] "Drives' force over command";
  input Units.RelativeForce authority "A channel clips at this force; 0: never";
  input Units.DimensionlessRatio driveOn "1 with the drive on, 0 off";
  input Units.RelativeDisplacement amplitudeAim "Detected amplitude to hold";
  input Units.DampingCoefficient amplitudeRate "Rate of the amplitude to hold";
  input Units.RelativeDisplacement quadratureAim "Detected quadrature to hold";
  input Units.Angle phaseAim "Detected phase to hold";
  input Units.Angle modalAim "Detected modal angle to hold in the force-to-rebalance mode";
  input Real rebalance "1 in the force-to-rebalance mode, 0 in the whole-angle mode";
  input Units.AngularVelocity patternRate "Commanded rotation of the pattern, in the whole-angle mode";
  output Real detection[6] "Detected orbit, as of deviation()";
  output Real motion[9] "As of precession()";
  output Units.DampingCoefficient growthRate "Force on the antinode over the detected amplitude";
  output Units.RelativeForce quadratureForce "Force on the node in quadrature";
  output Units.AngularVelocity drivenRate "Rotation of the pattern that is driven, as a command";
  output Units.AngularVelocity lostRate "Rotation that the drives' authority takes away, as a command";
  output Units.RelativeForce force[4] "Force in action, for the feedthrough, {cos x, sin x, cos y, sin y}";
protected
  final parameter Units.DampingCoefficient quickness = 1/(3*samplePeriod) "Of the loops";
  Units.AngularVelocity turning "Rate of the modal angle, as commanded and as the case turns";
  Units.Angle hold "Modal angle by which held forces lag in the mean";
  Units.Angle delay "Modal angle by which delayed forces lag";
  Units.DimensionlessRatio turn[2] "Cosine and sine of the delay, to fourth order";
  Units.DimensionlessRatio aim[2] "Cosine and sine of the modal angle that forces are resolved with";
  Units.RelativeForce antinode(start = 0, fixed = true) "Force on the antinode, as the pick-offs feel it";
  Units.RelativeForce node(start = 0, fixed = true) "Force on the node, likewise";
  Units.RelativeForce square(start = 0, fixed = true) "Force on the node in quadrature, likewise";
  Units.DimensionlessRatio command "Command over force; 0 with the drive off";
equation
  command = noEvent(if driveOn > 0 then 1/driveOn else 0);
  detection = deviation(analogue, axes);
  turning = (1 - rebalance)*(2*patternRate*driveOn - coupling);
  hold = controlPeriod/2*turning;
  delay = loopDelay*turning;
  turn = {1 - delay*delay/2, delay - delay*delay*delay/6};
  aim = {
    (turn[1] - hold*turn[2])*detection[4] + (turn[2] + hold*turn[1])*detection[5],
    (turn[1] - hold*turn[2])*detection[5] - (turn[2] + hold*turn[1])*detection[4]};
  motion = precession(
    freeRates, amplitude, quadrature, axes, detection[1], aim, driveGain, authority, driveOn,
    {quickness*(modalAim - modalAngle - detection[6]),
     quickness*(amplitudeAim - detection[1]) + amplitudeRate,
     quickness*(quadratureAim - detection[2]),
     quickness*(phaseAim - phase - detection[3])},
    patternRate*(1 - hold*hold/3), rebalance);
  der(antinode) = (motion[5] - antinode)/samplePeriod;
  der(node) = (motion[7] - node)/samplePeriod;
  der(square) = (motion[6] - square)/samplePeriod;
  growthRate = motion[5]/detection[1];
  quadratureForce = motion[6];
  drivenRate = motion[7]*command/(2*detection[1]);
  lostRate = motion[9]*command/(2*detection[1]);
  force = {
    antinode*axes[1] - node*axes[2],
    -square*axes[2],
    antinode*axes[2] + node*axes[1],
    square*axes[1]};
  annotation (Documentation(info="<html>
<p>Real loops settle in a second or two. Here amplitude, quadrature and phase approach their aims with a time constant of
three output periods, and forces follow at once; what is slower than that is as with the real loops. The angle that a change of
amplitude leaves by misaimed forces is right within 3 % up to a factor of three. Not in here: the loops' own transients, their
response to overload, and the noise of pick-offs on its way through them. With the drive off an orbit that becomes a circle
(a split that turns quadrature up to the amplitude) has no antinode, and the elements of the orbit end there.</p>
</html>"));
end QuasisteadyLoops;
