within HRG.Validation;
package Modes "Modes of operation and compensation"
  annotation (Documentation(info="<html>
<p>The same gyro as it is operated otherwise, and with its errors taken out.</p>
</html>"));
end Modes;
