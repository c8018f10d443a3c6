within HRG.Controls;
block ForceSynthesis "Loop commands, resolved from the pattern's axes into the electrodes'"
  parameter Units.Time samplePeriod "Control period";
  input Units.Ratio cosine "Of the detected modal angle";
  input Units.Ratio sine "Of the detected modal angle";
  input Units.Displacement amplitude "Detected antinode amplitude";
  input Units.Rate growthRate "Command of the amplitude loop";
  input Units.Force quadratureForce "Command of the quadrature loop";
  input Units.AngularRate patternRate "Commanded rotation of the pattern";
  discrete output Units.Force force[4](each start = 0, each fixed = true) "Force {cos x, sin x, cos y, sin y}";
protected
  discrete Units.Force antinode(start = 0, fixed = true) "Force on the antinode, in phase with the velocity";
  discrete Units.Force node(start = 0, fixed = true) "Force on the node, in phase with the velocity";
equation
  when sample(0, samplePeriod) then
    antinode = growthRate*amplitude;
    node = 2*patternRate*amplitude;
    force = {
      antinode*cosine - node*sine,
      -quadratureForce*sine,
      antinode*sine + node*cosine,
      quadratureForce*cosine};
  end when;
end ForceSynthesis;
