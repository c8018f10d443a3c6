within Strapdown.Algebra;
function compensated "Sum and its rounding error after a change"
  input Real total "Sum so far";
  input Real error "Its rounding error so far";
  input Real change "What is added";
  output Real result[2] "{sum, rounding error}";
protected
  Real added "The change less the error so far";
algorithm
  added := change - error;
  result[1] := total + added;
  result[2] := (result[1] - total) - added;
  annotation (Documentation(info="<html>
<p>W. Kahan, Further remarks on reducing truncation errors, CACM 8 (1965); Eq. 15. Millions of equal small changes all round the same way.</p>
</html>"));
end compensated;
