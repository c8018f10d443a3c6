within HRG.Noise;
function uniform "One step of L'Ecuyer's MRG32k3a: {state, uniform deviate within (0, 1)}"
  input Real state[6] "State: three whole numbers below m1, three below m2";
  output Real result[7] "Next state, and the deviate";
protected
  constant Real m1 = 4294967087 "First modulus";
  constant Real m2 = 4294944443 "Second modulus";
  Real p1 "First component";
  Real p2 "Second component";
  Real difference "Of the components, modulo m1";
algorithm
  p1 := 1403580*state[2] - 810728*state[1];
  p1 := p1 - m1*floor(p1/m1);
  p2 := 527612*state[6] - 1370589*state[4];
  p2 := p2 - m2*floor(p2/m2);
  difference := if p1 > p2 then p1 - p2 else p1 - p2 + m1;
  result[1] := state[2];
  result[2] := state[3];
  result[3] := p1;
  result[4] := state[5];
  result[5] := state[6];
  result[6] := p2;
  result[7] := difference/(m1 + 1);
  annotation (Documentation(info="<html>
<p>P. L'Ecuyer, Good parameters and implementations for combined multiple recursive random number generators,
Operations Research 47 (1999). All products stay below 2^53, so that the arithmetic is exact.</p>
</html>"));
end uniform;
