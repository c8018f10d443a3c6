within HRG.Noise;
block ElectronicsNoise "White noise of the force and pick-off channels, slow noise of the rate, noise of the virtual rotation"
  parameter Units.Time samplePeriod "Period of the noise";
  Boolean tick = sample(0, samplePeriod) "Each sample period";
  parameter Units.Time pickOffPeriod = samplePeriod "Period over which pick-off noise is averaged";
  parameter Units.DimensionlessRatio bryanFactor "Converts input rates into pattern rates";
  parameter Integer seed(min = 0, max = 2147483647) "Seed of the generators";
  parameter Units.AngleRandomWalk angleRandomWalk(max = 1e-2) = 0
    "White force noise, as the angle random walk coefficient N that it causes at nominal amplitude, in rad/sqrt(s), typically 3e-9 to 3e-7: 1e-5 to 1e-3 deg/sqrt(h)";
  parameter Units.NoiseDensity pickOff(max = 1e-2) = 0
    "White noise of each demodulated channel, relative to the nominal amplitude, in 1/sqrt(Hz), typically 3e-9 to 3e-8: 0.01 to 0.1 arcsec of pattern angle in 1 ms";
  parameter Units.RateRandomWalk rateRandomWalk(max = 1) = 0
    "Rate random walk coefficient K, in rad/s/sqrt(s), typically 4e-11 to 4e-10: 5e-4 to 5e-3 deg/h in an hour";
  parameter Units.AngularVelocity biasInstability(min = 0, max = 1) = 0
    "Flicker coefficient B, in rad/s, typically 2e-9 to 2e-8: 5e-4 to 5e-3 deg/h, the bias stability at a fixed pattern angle";
  parameter Units.NoiseDensity virtualRotation(max = 1) = 0
    "White relative noise of a commanded rotation, in 1/sqrt(Hz), typically 3e-6 to 2e-5: at 10 deg/s an angle random walk of 2e-3 to 1e-2 deg/sqrt(h)";
  Interfaces.Outputs.RelativeForce force[4] "Force noise {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{100, 65}, {120, 85}})));
  Interfaces.Outputs.RelativeDisplacement displacement[4] "Pick-off noise {cx, sx, cy, sy}"
    annotation (Placement(transformation(extent = {{100, 15}, {120, 35}})));
  Interfaces.Outputs.AngularVelocity patternRate "Slow noise, as a pattern rate"
    annotation (Placement(transformation(extent = {{100, -35}, {120, -15}})));
  Interfaces.Outputs.DimensionlessRatio rotation "Relative noise of the commanded rotation"
    annotation (Placement(transformation(extent = {{100, -85}, {120, -65}})));
protected
  final parameter Units.DimensionlessRatio start[84] = seededState(seed) "Memory at time 0";
  final parameter Units.RelativeForce forceDeviation = 2*bryanFactor*sqrt(angleRandomWalk^2/samplePeriod)
    "Standard deviation of a force channel";
  final parameter Units.RelativeDisplacement pickOffDeviation = sqrt(pickOff^2/pickOffPeriod) "Standard deviation of a pick-off channel";
  final parameter Units.AngularVelocity walkDeviation = bryanFactor*sqrt(rateRandomWalk^2*samplePeriod)
    "Standard deviation of a step of the rate random walk";
  final parameter Units.AngularVelocity flickerScale = bryanFactor*biasInstability*2.0794415416798357/Constants.pi
    "Of the sum of lags, ln 8/pi";
  final parameter Units.DimensionlessRatio rotationDeviation = sqrt(virtualRotation^2/samplePeriod) "Standard deviation of the rotation's noise";
  final parameter Units.DimensionlessRatio isMade = if angleRandomWalk > 0 or pickOff > 0 or rateRandomWalk > 0 or biasInstability > 0 or virtualRotation > 0 then 1 else 0
    "1 where there is any noise: else nothing is drawn for it";
  final parameter Units.DimensionlessRatio decays[16] = lagDecays(samplePeriod) "Of the lags over a period, and weights of their input";
  discrete Units.DimensionlessRatio memory[84](start = start, each fixed = true) "States of the generators, and the last deviates";
  discrete Units.DimensionlessRatio lags[8](each start = 0, each fixed = true) "Flicker noise";
  discrete Units.AngularVelocity walk(start = 0, fixed = true) "Rate random walk";
equation
  when tick then
    memory = if isMade > 0.5 then deviates(pre(memory)) else pre(memory);
    lags = flicker(pre(lags), decays, memory[81]);
    walk = pre(walk) + walkDeviation*memory[82];
  end when;
  force = {
    forceDeviation*memory[73],
    forceDeviation*memory[74],
    forceDeviation*memory[75],
    forceDeviation*memory[76]};
  displacement = {
    pickOffDeviation*memory[77],
    pickOffDeviation*memory[78],
    pickOffDeviation*memory[79],
    pickOffDeviation*memory[80]};
  patternRate = walk + flickerScale*(lags[1] + lags[2] + lags[3] + lags[4] + lags[5] + lags[6] + lags[7] + lags[8]);
  rotation = rotationDeviation*memory[83];
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Line(points = {{-80, 0}, {-60, 50}, {-40, -60}, {-20, 30}, {0, -40}, {20, 60}, {40, -20}, {60, 40}, {80, -50}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>Standard deviations of a sample of period T: force channels 2 k N/sqrt(T), since a force n on the node turns the
pattern at n/(2 a), so that the output has the angle random walk N at nominal amplitude; pick-off channels s/sqrt(T), s their <code>pickOff</code>;
rate random walk k K sqrt(T) a step; commanded rotation s/sqrt(T), relative. Flicker noise of coefficient B is the sum of
<code>flicker</code>, scaled by k B. Coefficients N, K and B are those of IEEE Std 952, none of them squared: N^2 and s^2 are two-sided densities. Mechanisms 18 and 20 to 22.</p>
</html>"));
end ElectronicsNoise;
