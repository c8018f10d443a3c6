within HRG.Examples;
package BaseClasses "What examples share"
  annotation (Documentation(info="<html>
<p>A gyro whose inputs are bound, to begin a model with.</p>
</html>"));
end BaseClasses;
