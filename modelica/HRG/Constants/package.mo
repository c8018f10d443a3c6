within HRG;
package Constants "Mathematical constants"
  constant Real pi = 3.14159265358979323846 "Circle number";
  annotation (Documentation(info="<html>
<p>What the equations need and the language does not have.</p>
</html>"));
end Constants;
