within Strapdown.Algebra;
function product "Product of two quaternions"
  input Real p[4] "First factor";
  input Real q[4] "Second factor";
  output Real result[4] "p q";
algorithm
  result[1] := p[1]*q[1] - p[2]*q[2] - p[3]*q[3] - p[4]*q[4];
  result[2] := p[1]*q[2] + p[2]*q[1] + p[3]*q[4] - p[4]*q[3];
  result[3] := p[1]*q[3] - p[2]*q[4] + p[3]*q[1] + p[4]*q[2];
  result[4] := p[1]*q[4] + p[2]*q[3] - p[3]*q[2] + p[4]*q[1];
  annotation (Documentation(info="<html>
<p>The rotation q, followed by the rotation p.</p>
</html>"));
end product;
