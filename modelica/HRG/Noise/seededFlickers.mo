within HRG.Noise;
function seededFlickers "Memory of three flicker noises for a seed, unrelated to that of seededState"
  input Real seed "Whole number from 0 to 2^31 - 1";
  output Real memory[45] "States of three MRG32k3a, and zeros where lags and sums go";
protected
  Real h "Hash, a whole number below the smaller modulus less one";
algorithm
  h := scrambled(scrambled(scrambled(scrambled(seed + 2345678917))));
  for i in 1:18 loop
    h := scrambled(h + 40014*i);
    memory[i] := h + 1;
  end for;
  for i in 19:45 loop
    memory[i] := 0;
  end for;
  annotation (Documentation(info="<html>
<p>As <code>seededState</code>, from a number of its own.</p>
</html>"));
end seededFlickers;
