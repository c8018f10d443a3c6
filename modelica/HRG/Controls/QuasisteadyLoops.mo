within HRG.Controls;
block QuasisteadyLoops "Loops that follow at once, and the forces they need"
  parameter Units.Time samplePeriod "Period of the output: loops come to rest within a few";
  parameter Units.Time controlPeriod = 1e-3 "Control period of the electronics, which hold their forces for it";
  parameter Units.Time loopDelay(min = 0, max = 0.1) = 0
    "Age of the angle that forces are resolved with, beyond the sample, typically up to 1e-3";
  input Real freeRates[4] "Rates of the displacement without drive, {cx, sx, cy, sy}";
  input Units.Displacement amplitude "True antinode amplitude";
  input Units.Displacement quadrature "True quadrature";
  input Units.Angle phase "True phase against the reference";
  input Units.Angle modalAngle "True modal angle";
  input Units.Ratio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.AngularRate coupling "Bryan coupling: the modal rate of a free pattern, negative";
  input Units.Displacement analogue[4] "Reading before noise and conversion";
  input Units.Ratio driveGain[4] "Drives' force over command";
  input Units.Force authority "A channel clips at this force; 0: never";
  input Units.Ratio driveOn "1 with the drive on, 0 off";
  input Units.Displacement amplitudeAim "Detected amplitude to hold";
  input Units.Displacement quadratureAim "Detected quadrature to hold";
  input Units.Angle phaseAim "Detected phase to hold";
  input Units.Angle modalAim "Detected modal angle to hold in the force-to-rebalance mode";
  input Real rebalance "1 in the force-to-rebalance mode, 0 in the whole-angle mode";
  input Units.AngularRate patternRate "Commanded rotation of the pattern, in the whole-angle mode";
  output Real detection[6] "Detected orbit, as of deviation()";
  output Real motion[8] "As of precession()";
  output Units.Rate growthRate "Force on the antinode over the detected amplitude, as commanded";
  output Units.Force quadratureForce "Force on the node in quadrature, as commanded";
  output Units.AngularRate drivenRate "Rotation of the pattern, as commanded";
  output Units.Force force[4] "Force in action, for the feedthrough, {cos x, sin x, cos y, sin y}";
protected
  final parameter Units.Rate quickness = 1/samplePeriod "Of the loops";
  Units.Angle lag "Modal angle by which the forces lag";
  Units.Ratio aim[2] "Cosine and sine of the modal angle that forces are resolved with";
  Units.Force antinode(start = 0, fixed = true) "Force on the antinode, as the pick-offs feel it";
  Units.Force node(start = 0, fixed = true) "Force on the node, likewise";
  Units.Force square(start = 0, fixed = true) "Force on the node in quadrature, likewise";
  Units.Ratio command "Command over force; 0 with the drive off";
equation
  command = noEvent(if driveOn > 0 then 1/driveOn else 0);
  detection = deviation(analogue, axes);
  lag = (controlPeriod/2 + loopDelay)*(1 - rebalance)*(2*patternRate*driveOn - coupling);
  aim = {detection[4] + lag*detection[5], detection[5] - lag*detection[4]};
  motion = precession(
    freeRates, amplitude, quadrature, axes, detection[1], aim, driveGain, authority, driveOn,
    {quickness*(modalAim - modalAngle - detection[6]),
     quickness*(amplitudeAim - detection[1]),
     quickness*(quadratureAim - detection[2]),
     quickness*(phaseAim - phase - detection[3])},
    patternRate, rebalance);
  der(antinode) = quickness*(motion[5] - antinode);
  der(node) = quickness*(motion[7] - node);
  der(square) = quickness*(motion[6] - square);
  growthRate = motion[5]*command/detection[1];
  quadratureForce = motion[6]*command;
  drivenRate = motion[7]*command/(2*detection[1]);
  force = {
    antinode*axes[1] - node*axes[2],
    -square*axes[2],
    antinode*axes[2] + node*axes[1],
    square*axes[1]};
  annotation (Documentation(info="<html>
<p>Real loops settle in a second or less. Here amplitude, quadrature and phase approach their aims with the
output period as time constant, and forces follow at once; what is slower than a few output periods is that of the real
loops. Not in here: the loops' own transients, their response to overload, and the noise of pick-offs on its way through
them.</p>
</html>"));
end QuasisteadyLoops;
