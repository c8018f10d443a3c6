within Strapdown;
package Mechanization "One step of the navigator, of two increments"
  annotation (Documentation(info="<html>
<p>Vectors that belong together are handed on as one: the comment of each says what stands where.</p>
</html>"));
end Mechanization;
