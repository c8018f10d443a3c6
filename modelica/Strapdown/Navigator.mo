within Strapdown;
model Navigator "Strapdown navigator: from the angles of three gyros and the velocities of three accelerometers to position, velocity and attitude"
  parameter Units.Time interval(min = 1e-3, max = 1) = 0.01 "Time between readings; a step of the navigator is two";
  parameter Units.Angle startLatitude(min = -1.562, max = 1.562) = 0 "Latitude at the start, half a degree short of the poles at most";
  parameter Units.Angle startLongitude(min = -10, max = 10) = 0 "Longitude at the start";
  parameter Units.Length startHeight(min = -1e8, max = 1e8) = 0 "Height above the ellipsoid at the start";
  parameter Units.Velocity startVelocity[3](each min = -1e5, each max = 1e5) = {0, 0, 0} "Velocity over ground at the start, north, east, down";
  parameter Units.Angle startHeading(min = -10, max = 10) = 0 "Heading at the start, clockwise from north";
  parameter Units.Angle startPitch(min = -10, max = 10) = 0 "Pitch at the start, nose up";
  parameter Units.Angle startRoll(min = -10, max = 10) = 0 "Roll at the start, right side down";
  parameter Units.AngularVelocity gyroBias[3](each min = -1, each max = 1) = {0, 0, 0} "Calibrated bias of each gyro, which is subtracted";
  parameter Units.DimensionlessRatio forwardShares[3](each min = -1e3, each max = 1e3) = {1, 0, 0} "Shares of the gyros' readings in the rotation about forward";
  parameter Units.DimensionlessRatio rightShares[3](each min = -1e3, each max = 1e3) = {0, 1, 0} "Shares of the gyros' readings in the rotation about right";
  parameter Units.DimensionlessRatio downShares[3](each min = -1e3, each max = 1e3) = {0, 0, 1} "Shares of the gyros' readings in the rotation about down";
  parameter Units.Switch heightClamped = 1 "1: height and climb rate are the reference's; 0: they are integrated";
  parameter Real heightGains[3](each min = 0, each max = 1) = {0, 0, 0} "Feedback of the height's excess over the reference to height, velocity and integral of the excess, in 1/s, 1/s2, 1/s3; 0: none";
  input Units.Angle gyroAngle[3](each min = -1e9, each max = 1e9, each start = 0) "Angles that the gyros have measured";
  input Units.Velocity velocity[3](each min = -1e9, each max = 1e9, each start = 0) "Sums of the accelerometers, forward, right, down";
  input Units.Count row(max = 1e9, start = 0) "Number of the interval that begins with this reading, from 1; 0: the motion has not begun";
  input Units.Length referenceHeight(min = -1e8, max = 1e8, start = 0) "Height of the reference";
  input Units.Velocity referenceClimbRate(min = -1e5, max = 1e5, start = 0) "Climb rate of the reference";
  output Units.Angle latitude "Geodetic latitude";
  output Units.Angle longitude "Longitude, not wrapped";
  output Units.Length height "Height above the ellipsoid";
  output Units.Velocity velocityNorth "Velocity over ground, north";
  output Units.Velocity velocityEast "Velocity over ground, east";
  output Units.Velocity velocityDown "Velocity over ground, down";
  output Units.Angle heading "Clockwise from north";
  output Units.Angle pitch "Nose up";
  output Units.Angle roll "Right side down";
  discrete output Units.Time navigationTime(start = 0, fixed = true) "Duration of the motion at whose end position, velocity and attitude are";
  output Units.Switch valid "1: no reading was missed, and the latitude is short of the poles";
protected
  final parameter Real start[17] = Mechanization.start({startLatitude, startLongitude, startHeight}, startVelocity, startHeading, startPitch, startRoll) "State at the start";
  discrete Units.Switch isNew(start = 0, fixed = true) "1: there is a reading that was not taken yet";
  discrete Units.Switch isLater(start = 0, fixed = true) "1: and it is not the first one";
  discrete Units.Switch isHalf(start = 0, fixed = true) "1: a step has begun with the last reading but one";
  discrete Units.Switch isStep(start = 0, fixed = true) "1: a step ends with the reading";
  discrete Units.Count taken(start = 0, fixed = true) "Interval that began with the reading taken last";
  discrete Units.Count missed(start = 0, fixed = true) "Number of readings that were not taken";
  discrete Units.Angle lastAngle[3](each start = 0, each fixed = true) "Angles of the reading taken last";
  discrete Units.Velocity lastVelocity[3](each start = 0, each fixed = true) "Sums of the reading taken last";
  discrete Units.Angle turned[3](each start = 0, each fixed = true) "Rotation in each gyro's axis since then";
  discrete Units.Angle rotation[6](each start = 0, each fixed = true) "Increments of rotation in body axes, the last two";
  discrete Units.Velocity increments[6](each start = 0, each fixed = true) "Increments of velocity, the last two";
  discrete Units.Length stepHeight(start = 0, fixed = true) "Height of the reference at the begin of the step";
  discrete Real state[17](start = start, each fixed = true) "State of function step";
equation
  when sample(0, 1e-3) then
    isNew = if row > pre(taken) + 0.5 then 1 else 0;
    isLater = if isNew > 0.5 and pre(taken) > 0.5 then 1 else 0;
    isHalf = if isLater > 0.5 then 1 - pre(isHalf) else pre(isHalf);
    isStep = if isLater > 0.5 and isHalf < 0.5 then 1 else 0;
    taken = if isNew > 0.5 then row else pre(taken);
    missed = pre(missed) + (if isNew > 0.5 then row - pre(taken) - 1 else 0);
    lastAngle = if isNew > 0.5 then gyroAngle else pre(lastAngle);
    lastVelocity = if isNew > 0.5 then velocity else pre(lastVelocity);
    turned = gyroAngle - pre(lastAngle) - interval*gyroBias;
    rotation = if isLater > 0.5 then {
      pre(rotation[4]), pre(rotation[5]), pre(rotation[6]),
      forwardShares[1]*turned[1] + forwardShares[2]*turned[2] + forwardShares[3]*turned[3],
      rightShares[1]*turned[1] + rightShares[2]*turned[2] + rightShares[3]*turned[3],
      downShares[1]*turned[1] + downShares[2]*turned[2] + downShares[3]*turned[3]} else pre(rotation);
    increments = if isLater > 0.5 then {
      pre(increments[4]), pre(increments[5]), pre(increments[6]),
      velocity[1] - pre(lastVelocity[1]), velocity[2] - pre(lastVelocity[2]), velocity[3] - pre(lastVelocity[3])} else pre(increments);
    state = if isStep > 0.5 then Mechanization.step(
      pre(state), rotation, increments, 2*interval, {pre(stepHeight), referenceHeight, referenceClimbRate}, heightGains, heightClamped) else pre(state);
    navigationTime = if isStep > 0.5 then interval*(taken - 1) else pre(navigationTime);
    stepHeight = if isNew > 0.5 and isHalf < 0.5 then referenceHeight else pre(stepHeight);
  end when;
  latitude = state[1];
  longitude = state[2];
  height = state[3];
  velocityNorth = state[4];
  velocityEast = state[5];
  velocityDown = state[6];
  heading = atan2(2*(state[8]*state[9] + state[7]*state[10]), 1 - 2*(state[9]^2 + state[10]^2));
  pitch = atan2(2*(state[7]*state[9] - state[8]*state[10]), sqrt((1 - 2*(state[9]^2 + state[10]^2))^2 + (2*(state[8]*state[9] + state[7]*state[10]))^2));
  roll = atan2(2*(state[9]*state[10] + state[7]*state[8]), 1 - 2*(state[8]^2 + state[9]^2));
  valid = noEvent(if missed < 0.5 and abs(state[1]) < 1.562 then 1 else 0);
  annotation (Documentation(info="<html>
<p>Dead reckoning from a known start, in steps of two readings, by <code>Mechanization.step</code>. Readings are sums since power-on, whose differences are the
increments. They are taken at the first sample after <code>row</code> has grown, so that communication steps may be as long as an interval or
divide it. All inputs are those of one communication point: the gyros' angles and the sums at its time, and the number of the interval that begins there.
What the gyros say before the first reading is left out.</p>
<p>A reading that is skipped is seen: <code>valid</code> is 0 from then on.</p>
</html>"));
end Navigator;
