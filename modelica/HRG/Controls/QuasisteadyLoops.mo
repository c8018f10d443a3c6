within HRG.Controls;
block QuasisteadyLoops "Loops that follow at once, and the forces they need"
  parameter Units.Time samplePeriod "Period of the output: loops come to rest within a few";
  Boolean tick = sample(0, samplePeriod) "Each period of the output";
  final parameter Units.Time controlPeriod = 1e-3 "Control period of the electronics, which hold their forces for it";
  parameter Units.Time loopDelay(min = 0, max = 0.1) = 0
    "Age of the angle that forces are resolved with, beyond the sample, typically up to 1e-3";
  parameter Units.DimensionlessRatio parametricShare "Share of the force on the antinode that parametric drive gives";
  parameter Integer timeDivision "1: the electrodes drive in one control period and sense in the next; 0: they do both at once";
  input Real freeRates[4] "Rates of the displacement without drive, {cx, sx, cy, sy}";
  input Units.RelativeDisplacement amplitude "True antinode amplitude";
  input Units.RelativeDisplacement quadrature "True quadrature";
  input Units.Angle phase "True phase against the reference";
  input Units.Angle modalAngle "True modal angle";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.AngularVelocity coupling "Bryan coupling 2 k Omega: minus the modal rate of a free pattern";
  input Units.RelativeDisplacement analogue[4] "Reading before noise and conversion";
  input Units.DimensionlessRatio driveGain[4] "Drives' force over command";
  input Units.DimensionlessRatio pumpGain[3] "Growth by parametric drive over command, of x, of y and between them";
  input Units.RelativeForce authority "A channel clips at this force; 0: never";
  input Units.DimensionlessRatio driveOn "1 with the drive on, 0 off";
  input Units.RelativeDisplacement amplitudeAim "Detected amplitude to hold";
  input Units.DampingCoefficient amplitudeRate "Rate of the amplitude to hold";
  input Units.RelativeDisplacement quadratureAim "Detected quadrature to hold";
  input Units.Angle phaseAim "Detected phase to hold";
  input Units.Angle modalAim "Detected modal angle to hold in the force-to-rebalance mode";
  input Units.AngularVelocity sweepRate "Commanded rotation of the pattern by the sweep";
  input Real rebalance "1 in the force-to-rebalance mode, 0 in the whole-angle mode";
  input Units.AngularVelocity patternRate "Commanded rotation of the pattern, in the whole-angle mode";
  output Real detection[6] "Detected orbit, as of deviation()";
  output Real motion[10] "As of precession()";
  output Units.DampingCoefficient growthRate "Force on the antinode over the detected amplitude";
  output Units.RelativeForce quadratureForce "Force on the node in quadrature";
  output Units.AngularFrequency reference "Reference frequency less the nominal one";
  output Units.AngularVelocity drivenRate "Rotation of the pattern that is driven, as a command";
  output Units.AngularVelocity lostRate "Rotation that the drives' authority takes away, as a command";
  output Units.RelativeForce force[4] "Mean force that readings show, {cos x, sin x, cos y, sin y}";
protected
  final parameter Units.DampingCoefficient perPeriod = 1/samplePeriod "Of the memories of a period";
  final parameter Units.DampingCoefficient quickness = 1/(3*samplePeriod) "Of the loops";
  Units.DimensionlessRatio commandShare "Rate of the modal angle per commanded one";
  Units.AngularVelocity freeTurning "Rate of the modal angle without a command";
  Units.AngularVelocity turning "Rate of the modal angle, as commanded and as the case turns";
  Units.Angle hold "Modal angle by which held forces lag in the mean";
  Units.Angle delay "Modal angle by which delayed forces lag";
  Units.DimensionlessRatio turn[2] "Cosine and sine of the delay, to fourth order";
  Units.DimensionlessRatio aim[2] "Cosine and sine of the modal angle that forces are resolved with";
  Units.RelativeForce antinode(start = 0, fixed = true) "Force of the electrodes on the antinode, as the pick-offs feel it";
  Units.RelativeForce node(start = 0, fixed = true) "Force on the node, likewise";
  Units.RelativeForce seen "Force on the node as far as readings show it";
  Units.RelativeForce led "Force on the node in quadrature, as far ahead as the quadrature that it asks for is behind";
  Units.RelativeForce square(start = 0, fixed = true) "Force on the node in quadrature, likewise";
  Units.DimensionlessRatio command "Command over force; 0 with the drive off";
  Units.DimensionlessRatio effort "Command over force on the shell; 0 where the drive does not hold the orbit, and in the first period";
  discrete Units.DimensionlessRatio started(start = 0, fixed = true) "1 from the first sample on";
  discrete Units.DimensionlessRatio passed(start = 0, fixed = true) "1 from the second sample on";
  Units.RelativeDisplacement quadratureError "Of the detected quadrature, with the gain of the amplitude taken out";
  Units.RelativeDisplacement lastQuadratureError(start = 0, fixed = true) "The same a period before";
  Units.Angle lastPhaseError(start = 0, fixed = true) "Error of the detected phase a period before";
  discrete Units.DimensionlessRatio last[3](each start = 0, each fixed = true) "Amplitude, quadrature and phase at the last sample";
  discrete Units.DimensionlessRatio change[3](each start = 0, each fixed = true) "Of them over the last period";
  discrete Units.RelativeForce lastSquare(start = 0, fixed = true) "Force on the node in quadrature at the last sample";
  discrete Units.RelativeForce squareChange(start = 0, fixed = true) "Its change over the last period";
  Units.DampingCoefficient mean[3] "Their mean rates over the last period";
equation
  command = noEvent(if driveOn > 0 then 1/driveOn else 0);
  detection = deviation(analogue, axes);
  quadratureError = detection[2]*amplitude/detection[1] - quadrature;
  der(lastQuadratureError) = perPeriod*(quadratureError - lastQuadratureError);
  der(lastPhaseError) = perPeriod*(detection[3] - lastPhaseError);
  commandShare = (1 - rebalance)*2*driveOn;
  freeTurning = rebalance*2*sweepRate*driveOn - (1 - rebalance)*coupling;
  turning = commandShare*patternRate + freeTurning;
  hold = controlPeriod/2*turning;
  delay = loopDelay*turning;
  turn = {1 - delay*delay/2, delay - 1/6*delay*(delay*delay)};
  aim = {
    (turn[1] - hold*turn[2])*detection[4] + (turn[2] + hold*turn[1])*detection[5],
    (turn[1] - hold*turn[2])*detection[5] - (turn[2] + hold*turn[1])*detection[4]};
  motion = precession(
    freeRates, amplitude, quadrature, axes, detection[1], aim, driveGain, pumpGain, parametricShare, authority, driveOn,
    {quickness*(modalAim - modalAngle - detection[6]) + 2*sweepRate,
     quickness*(amplitudeAim - detection[1]) + amplitudeRate,
     quickness*(quadratureAim - detection[2] - 3*(quadratureError - lastQuadratureError)),
     quickness*(phaseAim - phase - detection[3] - 3*(detection[3] - lastPhaseError))},
    patternRate*(1 - 1/3*hold*hold), rebalance);
  der(antinode) = perPeriod*((1 - parametricShare)*motion[5] - antinode);
  der(node) = perPeriod*(motion[7] - node);
  der(square) = perPeriod*(motion[6] - square);
  when tick then
    passed = pre(started);
    started = 1;
    last = {amplitude, quadrature, phase};
    change = last - pre(last);
    squareChange = square - pre(lastSquare);
    lastSquare = square;
  end when;
  mean = {change[1]/samplePeriod, change[2]/samplePeriod, change[3]/samplePeriod};
  effort = 2*passed*motion[10]/(driveGain[1] + driveGain[4]);
  growthRate = (motion[5] + effort*(mean[1] - motion[2]))/detection[1];
  quadratureForce = motion[6] + effort*(mean[2] - motion[3]);
  reference = motion[8] - passed*(mean[3] - motion[4]);
  drivenRate = motion[7]*command/(2*detection[1]);
  lostRate = motion[9]*command/(2*detection[1]);
  seen = (1 - timeDivision)*node;
  led = square + squareChange;
  force = {
    antinode*axes[1] - seen*axes[2],
    -led*axes[2],
    antinode*axes[2] + seen*axes[1],
    led*axes[1]};
  annotation (Documentation(info="<html>
<p>Real loops settle in a second or two. Here amplitude, quadrature and phase approach their aims with a time constant of
three output periods, and forces follow at once; what is slower than that is as with the real loops. The angle that a change of
amplitude leaves by misaimed forces is right within 3 % up to a factor of three. Inputs and temperature are held from sample to sample, so that the loops catch up with a pick-off's gain or phase in steps. They leave r = 1 - 1/3 + 1/18 of each step
by the end of its period: of the mean that a force needs, its value there is r/(3 (1 - r)) = 13/15, or 1/(3 (1 - r)) = 6/5 where the next step has come. Forces and reference
that are shown are therefore means of the last period. In time division a reading is half a control period of the holding force below the mean, and shows no force that rotates. While the pattern
turns, a pick-off asks for a quadrature and a phase that change. Real loops follow without a lag of first order. Here the loop is three periods late, and it is led by three times the change of its error over a period;
the force that a reading shows is one period late, and it is led by one change. Amplitude is not led. Not in here: the loops' own transients, their
response to overload, and the noise of pick-offs on its way through them. With the drive off an orbit that becomes a circle
(a split that turns quadrature up to the amplitude) has no antinode, and the elements of the orbit end there.</p>
</html>"));
end QuasisteadyLoops;
