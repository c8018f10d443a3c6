within Strapdown.Algebra;
function rotate "Vector, turned by a quaternion of unit length"
  input Real q[4] "Quaternion";
  input Real v[3] "Vector";
  output Real result[3] "The vector in the axes that the quaternion leads to";
protected
  Real axis[3] "Vector part of the quaternion";
  Real twice[3] "2 axis x v";
algorithm
  axis := {q[2], q[3], q[4]};
  twice := 2*vectorProduct(axis, v);
  result := v + (q[1]*twice + vectorProduct(axis, twice));
  annotation (Documentation(info="<html>
<p>v + 2 w u x v + 2 u x (u x v) with the scalar w and the vector part u.</p>
</html>"));
end rotate;
