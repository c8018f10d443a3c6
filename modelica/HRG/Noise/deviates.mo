within HRG.Noise;
function deviates "Advances eight generators by one step: {states, eight standard normal deviates}"
  input Real memory[56] "States of eight MRG32k3a (x[n-3], x[n-2], x[n-1], y[n-3], y[n-2], y[n-1] of all), and the last deviates";
  output Real result[56] "Next states, and the next deviates";
protected
  constant Real m1 = 4294967087 "First modulus";
  constant Real m2 = 4294944443 "Second modulus";
  constant Real unit = 1/4294967088 "Of the uniform deviate, 1/(m1 + 1)";
  Real x "First component";
  Real y "Second component";
  Real difference "Of the components, modulo m1";
algorithm
  for i in 1:8 loop
    x := 1403580*memory[8 + i] - 810728*memory[i];
    x := x - m1*floor(x/m1);
    y := 527612*memory[40 + i] - 1370589*memory[24 + i];
    y := y - m2*floor(y/m2);
    result[i] := memory[8 + i];
    result[8 + i] := memory[16 + i];
    result[16 + i] := x;
    result[24 + i] := memory[32 + i];
    result[32 + i] := memory[40 + i];
    result[40 + i] := y;
    difference := x - y;
    result[48 + i] := unit*(if difference > 0 then difference else difference + m1);
  end for;
  for i in 49:56 loop
    result[i] := normalQuantile(result[i]);
  end for;
  annotation (Documentation(info="<html>
<p>P. L'Ecuyer, Good parameters and implementations for combined multiple recursive random number generators,
Operations Research 47 (1999). All products stay below 2^53, so that the arithmetic is exact; the deviates are
quantiles of uniform ones within (0, 1). A generator for each deviate lets a processor advance them side by side.</p>
</html>"));
end deviates;
