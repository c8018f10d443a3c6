within HRG.Controls;
function forceReading "Sensitivity of a force to eight states, and what the force is beyond the expected one"
  input Real expected[22] "Coefficients of the terms in the expected force";
  input Real sensitivity[128] "Change of the first 16 per state, all states of a term side by side";
  input Real term[22] "Terms";
  input Units.DampingCoefficient force "Measured force";
  input Real used "1; 0 if the force is not to be read";
  output Real result[9] "{sensitivities to the eight states, excess of the force}";
algorithm
  result[9] := used*force;
  for t in 1:22 loop
    result[9] := result[9] - used*expected[t]*term[t];
  end for;
  for s in 1:8 loop
    result[s] := 0;
    for t in 1:16 loop
      result[s] := result[s] + used*sensitivity[8*t - 8 + s]*term[t];
    end for;
  end for;
  annotation (Documentation(info="<html>
<p>One row of a linear measurement y = H x + v. All is zero where it is not to be read, so that it says nothing.</p>
</html>"));
end forceReading;
