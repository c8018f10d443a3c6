within HRG.Noise;
function flickers "One step of three flicker noises, each of a generator of its own"
  input Real memory[45] "States of three MRG32k3a (x[n-3], x[n-2], x[n-1], y[n-3], y[n-2], y[n-1] of all), eight lags of each, sum of each one's lags";
  input Real decays[16] "As of lagDecays()";
  output Real result[45] "Next states, lags and sums";
protected
  constant Real m1 = 4294967087.0 "First modulus";
  constant Real m2 = 4294944443.0 "Second modulus";
  constant Real unit = 1/4294967088.0 "Of the uniform deviate, 1/(m1 + 1)";
  Real x "First component";
  Real y "Second component";
  Real difference "Of the components, modulo m1";
  Real deviate "Uniform, of variance 1";
  Real lag "One of eight";
  Real sum "Of them";
algorithm
  for i in 1:3 loop
    x := 1403580*memory[3 + i] - 810728*memory[i];
    x := x - m1*floor(x/m1);
    y := 527612*memory[15 + i] - 1370589*memory[9 + i];
    y := y - m2*floor(y/m2);
    result[i] := memory[3 + i];
    result[3 + i] := memory[6 + i];
    result[6 + i] := x;
    result[9 + i] := memory[12 + i];
    result[12 + i] := memory[15 + i];
    result[15 + i] := y;
    difference := x - y;
    deviate := 3.4641016151377544*(unit*(if difference > 0 then difference else difference + m1) - 0.5);
    sum := 0;
    for j in 1:8 loop
      lag := memory[10 + 8*i + j]*decays[j] + deviate*decays[8 + j];
      result[10 + 8*i + j] := lag;
      sum := sum + lag;
    end for;
    result[42 + i] := sum;
  end for;
  annotation (Documentation(info="<html>
<p>The generators are those of <code>deviates</code>, the lags those of <code>flicker</code>, for three at once.</p>
</html>"));
end flickers;
