within HRG.Validation;
package Environment "Temperature, bias voltage, vibration, specific force, mounting angle and age"
  annotation (Documentation(info="<html>
<p>Each changes a parameter of the gyro by its law.</p>
</html>"));
end Environment;
