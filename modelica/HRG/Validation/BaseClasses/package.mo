within HRG.Validation;
package BaseClasses "What claims are made of"
  annotation (Documentation(info="<html>
<p><code>Claim</code> is the root of all; the others add what several claims measure.</p>
</html>"));
end BaseClasses;
