within HRG.Noise;
function seededState "State of the generator for a seed; different seeds give unrelated streams"
  input Real seed "Whole number from 0 to 2^31 - 1";
  output Real state[6] "State of MRG32k3a";
protected
  Real h "Hash, a whole number below the smaller modulus";
algorithm
  h := scrambled(scrambled(scrambled(scrambled(seed + 1234567891))));
  for i in 1:6 loop
    h := scrambled(h + 40014*i);
    state[i] := h + 1;
  end for;
end seededState;
