within Strapdown.Algebra;
function vectorProduct "Cross product of two vectors"
  input Real a[3] "First factor";
  input Real b[3] "Second factor";
  output Real result[3] "a x b";
algorithm
  result[1] := a[2]*b[3] - a[3]*b[2];
  result[2] := a[3]*b[1] - a[1]*b[3];
  result[3] := a[1]*b[2] - a[2]*b[1];
  annotation (Documentation(info="<html>
<p>The operator <code>cross</code> of the Modelica language, which the generator of this project does not know.</p>
</html>"));
end vectorProduct;
