within HRG.Interfaces;
package Inputs "Connectors that are inputs, by quantity"
  connector Angle = input Units.Angle "Input of an angle"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector AngularVelocity = input Units.AngularVelocity "Input of a rotation rate"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector AngularFrequency = input Units.AngularFrequency "Input of a circular frequency"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector DampingCoefficient = input Units.DampingCoefficient "Input of a rate of growth or decay"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector DimensionlessRatio = input Units.DimensionlessRatio "Input of a dimensionless number"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector Switch = input Units.Switch "Input of a switch, 1 or 0"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector RelativeDisplacement = input Units.RelativeDisplacement "Input of a modal displacement"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector RelativeForce = input Units.RelativeForce "Input of a modal force"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector Temperature = input Units.Temperature "Input of an absolute temperature"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  connector Acceleration = input Units.Acceleration "Input of a specific force"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {0, 0, 127}, fillPattern = FillPattern.Solid)}));
  annotation (Documentation(info="<html>
<p>Each carries one real number with the unit of the type of <code>Units</code> that it is named after; arrays of them carry the
{cx, sx, cy, sy} of a displacement or a force.</p>
</html>"));
end Inputs;
