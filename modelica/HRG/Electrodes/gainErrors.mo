within HRG.Electrodes;
function gainErrors "Gain mismatch, non-orthogonality and rotation that make up a matrix of gains"
  input Real xx "x by x";
  input Real xy "x by y";
  input Real yx "y by x";
  input Real yy "y by y";
  output Real errors[4] "{scale less one, gain mismatch, non-orthogonality, rotation}";
protected
  Real length "Gain of x";
  Real c "Cosine of the rotation";
  Real s "Sine of the rotation";
  Real across "Gain of y";
algorithm
  length := sqrt(xx*xx + xy*xy);
  c := xx/length;
  s := -xy/length;
  across := yx*s + yy*c;
  errors[1] := (length + across)/2 - 1;
  errors[2] := 2*(length - across)/(length + across);
  errors[3] := (yx*c - yy*s)/across;
  errors[4] := atan2(s, c);
  annotation (Documentation(info="<html>
<p>scale [[1 + g/2, 0], [0, 1 - g/2]] [[1, 0], [d, 1]] [[cos e, -sin e], [sin e, cos e]] is the matrix [[xx, xy], [yx, yy]].</p>
</html>"));
end gainErrors;
