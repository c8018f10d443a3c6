within HRG.Controls;
function forceReading "Sensitivity of a force to nine states, and what the force is beyond the expected one"
  input Real expected[23] "Coefficients of the terms in the expected force";
  input Real sensitivity[153] "Change of the first 17 per state, all states of a term side by side";
  input Real term[23] "Terms";
  input Units.DampingCoefficient force "Measured force";
  input Real used "1; 0 if the force is not to be read";
  output Real result[10] "{sensitivities to the nine states, excess of the force}";
algorithm
  result[10] := used*force;
  for t in 1:23 loop
    result[10] := result[10] - used*expected[t]*term[t];
  end for;
  for s in 1:9 loop
    result[s] := 0;
    for t in 1:17 loop
      result[s] := result[s] + used*sensitivity[9*t - 9 + s]*term[t];
    end for;
  end for;
  annotation (Documentation(info="<html>
<p>One row of a linear measurement y = H x + v. All is zero where it is not to be read, so that it says nothing.</p>
</html>"));
end forceReading;
