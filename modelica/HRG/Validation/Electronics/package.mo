within HRG.Validation;
package Electronics "Errors of timing, of scale and of commanded rotation"
  annotation (Documentation(info="<html>
<p>Held and delayed forces, clock, Bryan factor and quantization.</p>
</html>"));
end Electronics;
