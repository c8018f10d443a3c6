within HRG.Noise;
function drawn "The next deviates, where they are needed"
  input Real memory[84] "As of deviates()";
  input Real isNeeded "1, or 0 to leave all as it is";
  output Real result[84] "Next memory";
algorithm
  result := if isNeeded > 0.5 then deviates(memory) else memory;
  annotation (Documentation(info="<html>
<p>A gyro without noise is simulated in three quarters of the time.</p>
</html>"));
end drawn;
