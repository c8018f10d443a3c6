within Strapdown;
model Accelerometers "Three accelerometers along the body axes, whose readings are summed"
  parameter Units.Time samplePeriod(min = 1e-3, max = 1) = 0.01 "Time between readings";
  parameter Units.Acceleration bias[3](each min = -100, each max = 100) = {0, 0, 0} "Bias";
  parameter Units.DimensionlessRatio scaleFactor[3](each min = -0.5, each max = 0.5) = {0, 0, 0} "Relative error of the scale factor";
  parameter Units.Angle misalignment[6](each min = -0.5, each max = 0.5) = {0, 0, 0, 0, 0, 0}
    "Sensitivity of x to y and z, of y to x and z, of z to x and y";
  parameter Units.VelocityRandomWalk randomWalk(max = 1) = 0 "Velocity random walk coefficient N";
  parameter Integer seed(min = 0, max = 2147483647) = 1 "Seed of the noise";
  input Units.Acceleration specificForce[3](each min = -1e5, each max = 1e5, each start = 0) "Mean specific force over a period, forward, right, down";
  input Units.Count row(max = 1e9, start = 0) "Number of the present period, from 1; 0: the motion has not begun";
  discrete output Units.Velocity velocity[3](each start = 0, each fixed = true) "Sums since the motion began";
protected
  final parameter Real startMemory[84] = HRG.Noise.seededState(seed) "Memory of the noise at time 0";
  discrete Units.Switch started(start = 0, fixed = true) "1 from the first sample on";
  discrete Units.Switch isNew(start = 0, fixed = true) "1: a period has ended";
  discrete Units.Count taken(start = 0, fixed = true) "Number of the last period in the sums";
  discrete Real memory[84](start = startMemory, each fixed = true) "States of the generators, and the last deviates";
  discrete Units.Velocity change[3](each start = 0, each fixed = true) "Reading over the period";
  discrete Units.Velocity error[3](each start = 0, each fixed = true) "Rounding errors of the sums";
equation
  when sample(0, samplePeriod) then
    started = 1;
    isNew = if pre(started) > 0.5 and row > pre(taken) + 0.5 then 1 else 0;
    taken = if isNew > 0.5 then row else pre(taken);
    memory = if isNew > 0.5 and randomWalk > 0 then HRG.Noise.deviates(pre(memory)) else pre(memory);
    change = {
      samplePeriod*((1 + scaleFactor[1])*specificForce[1] + misalignment[1]*specificForce[2] + misalignment[2]*specificForce[3] + bias[1]) + sqrt(samplePeriod)*randomWalk*memory[73],
      samplePeriod*(misalignment[3]*specificForce[1] + (1 + scaleFactor[2])*specificForce[2] + misalignment[4]*specificForce[3] + bias[2]) + sqrt(samplePeriod)*randomWalk*memory[74],
      samplePeriod*(misalignment[5]*specificForce[1] + misalignment[6]*specificForce[2] + (1 + scaleFactor[3])*specificForce[3] + bias[3]) + sqrt(samplePeriod)*randomWalk*memory[75]};
    velocity = if isNew > 0.5 then pre(velocity) + (change - pre(error)) else pre(velocity);
    error = if isNew > 0.5 then (velocity - pre(velocity)) - (change - pre(error)) else pre(error);
  end when;
  annotation (Documentation(info="<html>
<p>Bias, scale factor, misalignment (Groves 2013, Eq. 4.16) and velocity random walk (IEEE Std 952) of three sensors along the body axes. The
noise is that of <code>HRG.Noise</code>; its seed should be none of the gyros'. Sums are compensated (Kahan 1965).</p>
</html>"));
end Accelerometers;
