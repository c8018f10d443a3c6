within HRG.Noise;
function seededState "Memory of twelve generators for a seed; different seeds give unrelated streams"
  input Real seed "Whole number from 0 to 2^31 - 1";
  output Real memory[84] "States of twelve MRG32k3a, and zeros where the deviates go";
protected
  Real h "Hash, a whole number below the smaller modulus less one";
algorithm
  h := scrambled(scrambled(scrambled(scrambled(seed + 1234567891))));
  for i in 1:12 loop
    memory[i] := seed + 1;
  end for;
  for i in 13:72 loop
    h := scrambled(h + 40014*i);
    memory[i] := h + 1;
  end for;
  for i in 73:84 loop
    memory[i] := 0;
  end for;
  annotation (Documentation(info="<html>
<p>Twelve states hold the seed itself, so that no two seeds give the same; the others are a chain of <code>scrambled</code>, from 1 to the smaller modulus less one. No generator
starts at zero.</p>
</html>"));
end seededState;
