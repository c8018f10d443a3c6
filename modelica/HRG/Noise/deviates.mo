within HRG.Noise;
function deviates "Advances the generator: {state, eight standard normal deviates}"
  input Real memory[14] "State of the generator, and the last deviates";
  output Real result[14] "Next state, and the next deviates";
protected
  Real step[7] "State and uniform deviate";
algorithm
  for i in 1:6 loop
    step[i] := memory[i];
  end for;
  step[7] := 0;
  for i in 1:8 loop
    step := uniform({step[1], step[2], step[3], step[4], step[5], step[6]});
    result[6 + i] := normalQuantile(step[7]);
  end for;
  for i in 1:6 loop
    result[i] := step[i];
  end for;
end deviates;
