within HRG;
package Units "Types with units; SI throughout"
  type Angle = Real(quantity = "Angle", unit = "rad", displayUnit = "deg") "Angle";
  type AngularVelocity = Real(quantity = "AngularVelocity", unit = "rad/s", displayUnit = "deg/h") "Rotation rate";
  type AngularFrequency = Real(quantity = "AngularFrequency", unit = "rad/s", displayUnit = "Hz") "Circular frequency";
  type DampingCoefficient = Real(quantity = "DampingCoefficient", unit = "1/s") "Rate of growth or decay";
  type Time = Real(quantity = "Time", unit = "s") "Time";
  type DimensionlessRatio = Real(unit = "1") "Dimensionless number";
  type Switch = Real(unit = "1", min = 0, max = 1) "1: on, or true; 0: off, or false";
  type RelativeDisplacement = Real(quantity = "RelativeDisplacement", unit = "1")
    "Modal displacement relative to the nominal antinode amplitude";
  type RelativeForce = Real(quantity = "RelativeForce", unit = "1/s")
    "Modal force as the growth that it gives to the envelope, relative to the nominal amplitude";
  type Temperature = Real(quantity = "ThermodynamicTemperature", unit = "K", displayUnit = "degC") "Absolute temperature";
  type TemperatureDifference = Real(quantity = "TemperatureDifference", unit = "K") "Temperature above the reference";
  type LinearTemperatureCoefficient = Real(quantity = "LinearTemperatureCoefficient", unit = "1/K") "Relative change per temperature";
  type Acceleration = Real(quantity = "Acceleration", unit = "m/s2") "Specific force";
  type PerAcceleration = Real(unit = "s2/m") "Relative change per specific force";
  type AngleRandomWalk = Real(quantity = "AngleRandomWalk", unit = "rad/sqrt(s)", min = 0)
    "Angle random walk coefficient: root of the two-sided density of a white rotation rate";
  type RateRandomWalk = Real(quantity = "RateRandomWalk", unit = "rad/s/sqrt(s)", min = 0)
    "Rate random walk coefficient: root of the two-sided density of a white angular acceleration";
  type NoiseDensity = Real(quantity = "NoiseDensity", unit = "1/sqrt(Hz)", min = 0)
    "Root of the two-sided density of a white relative quantity";
  annotation (Documentation(info="<html>
<p>Names, quantities and units are those of <code>Modelica.Units.SI</code> where that has the quantity. The others are relative to the nominal
amplitude, or coefficients of noise by IEEE Std 952, whose units have a root.</p>
</html>"));
end Units;
