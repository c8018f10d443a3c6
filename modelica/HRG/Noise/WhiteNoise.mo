within HRG.Noise;
block WhiteNoise "Two groups of four white noises, drawn anew each control period"
  parameter Units.Time samplePeriod "Control period";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of the generators";
  parameter Real densityA = 0 "Two-sided density of the first group";
  parameter Real densityB = 0 "Two-sided density of the second group";
  output Real a[4] "First group";
  output Real b[4] "Second group";
protected
  final parameter Real state[56] = seededState(seed) "Memory at time 0";
  final parameter Real scaleA = sqrt(densityA/samplePeriod) "Standard deviation of the first group";
  final parameter Real scaleB = sqrt(densityB/samplePeriod) "Standard deviation of the second group";
  discrete Real memory[56](start = state, each fixed = true)
    "States of the generators, and the last deviates";
equation
  when sample(0, samplePeriod) then
    memory = deviates(pre(memory));
  end when;
  a = {scaleA*memory[49], scaleA*memory[50], scaleA*memory[51], scaleA*memory[52]};
  b = {scaleB*memory[53], scaleB*memory[54], scaleB*memory[55], scaleB*memory[56]};
end WhiteNoise;
