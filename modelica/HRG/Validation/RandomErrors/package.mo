within HRG.Validation;
package RandomErrors "Noise, by its Allan deviation"
  annotation (Documentation(info="<html>
<p>Each noise is held to the Allan deviation of its coefficient.</p>
</html>"));
end RandomErrors;
