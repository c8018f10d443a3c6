within HRG;
package Examples "Small models to open first"
  annotation (Documentation(info="<html>
<p>Each runs as it is. What a gyro with one thing wrong shows is in <code>HRG.Validation</code>.</p>
</html>"));
end Examples;
