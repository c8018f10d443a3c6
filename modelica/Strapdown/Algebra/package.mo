within Strapdown;
package Algebra "Vectors, quaternions and sums without drift"
  annotation (Documentation(info="<html>
<p>Quaternions have their scalar first.</p>
</html>"));
end Algebra;
