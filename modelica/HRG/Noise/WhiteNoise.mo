within HRG.Noise;
block WhiteNoise "Two groups of four white noises, drawn anew each control period"
  parameter Units.Time samplePeriod "Control period";
  parameter Integer seed(min = 0, max = 2147483647) = 0 "Seed of the generator";
  parameter Real densityA = 0 "Two-sided density of the first group";
  parameter Real densityB = 0 "Two-sided density of the second group";
  output Real a[4] "First group";
  output Real b[4] "Second group";
protected
  final parameter Real state[6] = seededState(seed) "State at time 0";
  final parameter Real scaleA = sqrt(densityA/samplePeriod) "Standard deviation of the first group";
  final parameter Real scaleB = sqrt(densityB/samplePeriod) "Standard deviation of the second group";
  discrete Real memory[14](
    start = {state[1], state[2], state[3], state[4], state[5], state[6], 0, 0, 0, 0, 0, 0, 0, 0},
    each fixed = true) "State of the generator, and the last deviates";
equation
  when sample(0, samplePeriod) then
    memory = deviates(pre(memory));
  end when;
  a = {scaleA*memory[7], scaleA*memory[8], scaleA*memory[9], scaleA*memory[10]};
  b = {scaleB*memory[11], scaleB*memory[12], scaleB*memory[13], scaleB*memory[14]};
end WhiteNoise;
