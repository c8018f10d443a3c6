within HRG.Noise;
block ChannelNoise "White noise of the four force and the four pick-off channels, drawn anew each control period"
  parameter Units.Time samplePeriod "Control period";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of the generators";
  parameter Units.Rate forceDensity(min = 0) = 0 "Two-sided density of each force channel";
  parameter Units.DisplacementNoiseDensity pickOffDensity = 0 "Two-sided density of each pick-off channel";
  output Units.Force force[4] "Force noise {cos x, sin x, cos y, sin y}";
  output Units.Displacement pickOff[4] "Pick-off noise {cx, sx, cy, sy}";
protected
  final parameter Units.Ratio start[56] = seededState(seed) "Memory at time 0";
  final parameter Units.Force forceDeviation = sqrt(forceDensity/samplePeriod) "Standard deviation of a force channel";
  final parameter Units.Displacement pickOffDeviation = sqrt(pickOffDensity/samplePeriod)
    "Standard deviation of a pick-off channel";
  discrete Units.Ratio memory[56](start = start, each fixed = true)
    "States of the generators, and the last deviates";
equation
  when sample(0, samplePeriod) then
    memory = deviates(pre(memory));
  end when;
  force = {
    forceDeviation*memory[49],
    forceDeviation*memory[50],
    forceDeviation*memory[51],
    forceDeviation*memory[52]};
  pickOff = {
    pickOffDeviation*memory[53],
    pickOffDeviation*memory[54],
    pickOffDeviation*memory[55],
    pickOffDeviation*memory[56]};
end ChannelNoise;
