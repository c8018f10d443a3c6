within HRG.Validation;
package Electronics "Errors of timing, of scale and of commanded rotation"
  annotation (Documentation(info="<html>
<p>Held and delayed forces, filter and time division of the demodulation, clock, Bryan factor and quantization.</p>
</html>"));
end Electronics;
