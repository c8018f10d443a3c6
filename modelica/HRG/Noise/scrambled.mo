within HRG.Noise;
function scrambled "Hash of a whole number: the square of its low half, mixed in"
  input Real number "Whole number, at least 0 and below 2^52";
  output Real hash "Whole number below 4294944442";
protected
  constant Real m = 4294944442.0 "The smaller modulus of MRG32k3a, less one";
  Real low "Lowest 26 bits: their square is exact";
  Real sum "Still to be reduced";
algorithm
  low := number - 67108864*floor(number/67108864);
  sum := low*low + number;
  hash := sum - m*floor(sum/m);
  annotation (Documentation(info="<html>
<p>With n the number and l its lowest 26 bits, (l^2 + n) modulo m: every step stays below 2^53, exact in a Real.</p>
</html>"));
end scrambled;
