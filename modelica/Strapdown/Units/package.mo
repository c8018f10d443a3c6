within Strapdown;
package Units "Types with units; SI throughout"
  type Angle = Real(quantity = "Angle", unit = "rad", displayUnit = "deg") "Angle";
  type AngularVelocity = Real(quantity = "AngularVelocity", unit = "rad/s", displayUnit = "deg/h") "Rotation rate";
  type Time = Real(quantity = "Time", unit = "s") "Time";
  type Length = Real(quantity = "Length", unit = "m") "Length";
  type Velocity = Real(quantity = "Velocity", unit = "m/s") "Velocity";
  type Acceleration = Real(quantity = "Acceleration", unit = "m/s2") "Specific force";
  type VelocityRandomWalk = Real(quantity = "VelocityRandomWalk", unit = "m/s/sqrt(s)", min = 0)
    "Velocity random walk coefficient: root of the two-sided density of a white specific force";
  type DimensionlessRatio = Real(unit = "1") "Dimensionless number";
  type Count = Real(unit = "1", min = 0) "A number of things";
  type Switch = Real(unit = "1", min = 0, max = 1) "1: on, or true; 0: off, or false";
  annotation (Documentation(info="<html>
<p>Names, quantities and units are those of <code>Modelica.Units.SI</code> where that has the quantity.</p>
</html>"));
end Units;
