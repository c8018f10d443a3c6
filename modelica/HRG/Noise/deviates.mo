within HRG.Noise;
function deviates "Advances twelve generators by one step: {states, eight standard normal deviates, four uniform ones of variance 1}"
  input Real memory[84] "States of twelve MRG32k3a (x[n-3], x[n-2], x[n-1], y[n-3], y[n-2], y[n-1] of all), and the last deviates";
  output Real result[84] "Next states, and the next deviates";
protected
  constant Real m1 = 4294967087.0 "First modulus";
  constant Real m2 = 4294944443.0 "Second modulus";
  constant Real unit = 1/4294967088.0 "Of the uniform deviate, 1/(m1 + 1)";
  Real x "First component";
  Real y "Second component";
  Real difference "Of the components, modulo m1";
  Real central[8] "Normal quantiles, right where the uniform deviate is within 0.49 of the median";
algorithm
  for i in 1:12 loop
    x := 1403580*memory[12 + i] - 810728*memory[i];
    x := x - m1*floor(x/m1);
    y := 527612*memory[60 + i] - 1370589*memory[36 + i];
    y := y - m2*floor(y/m2);
    result[i] := memory[12 + i];
    result[12 + i] := memory[24 + i];
    result[24 + i] := x;
    result[36 + i] := memory[48 + i];
    result[48 + i] := memory[60 + i];
    result[60 + i] := y;
    difference := x - y;
    result[72 + i] := unit*(if difference > 0 then difference else difference + m1);
  end for;
  for i in 1:8 loop
    central[i] := centralQuantile(result[72 + i] - 0.5);
  end for;
  for i in 1:8 loop
    result[72 + i] := if abs(result[72 + i] - 0.5) <= 0.49 then central[i] else tailQuantile(result[72 + i]);
  end for;
  for i in 81:84 loop
    result[i] := 3.4641016151377544*(result[i] - 0.5);
  end for;
  annotation (Documentation(info="<html>
<p>P. L'Ecuyer, Good parameters and implementations for combined multiple recursive random number generators,
Operations Research 47 (1999). All products stay below 2^53, so that the arithmetic is exact; the first eight deviates are
normal quantiles of uniform ones within (0, 1), the others, of which many are summed, uniform. A generator for each deviate lets
a processor advance them side by side.</p>
</html>"));
end deviates;
