within HRG.Interfaces;
package Outputs "Connectors that are outputs, by quantity"
  connector Angle = output Units.Angle "Output of an angle"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector AngularVelocity = output Units.AngularVelocity "Output of a rotation rate"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector AngularFrequency = output Units.AngularFrequency "Output of a circular frequency"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector DampingCoefficient = output Units.DampingCoefficient "Output of a rate of growth or decay"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector DimensionlessRatio = output Units.DimensionlessRatio "Output of a dimensionless number"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector Switch = output Units.Switch "Output of a switch, 1 or 0"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector RelativeDisplacement = output Units.RelativeDisplacement "Output of a modal displacement"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  connector RelativeForce = output Units.RelativeForce "Output of a modal force"
    annotation (Icon(graphics = {Polygon(points = {{-100, 100}, {100, 0}, {-100, -100}}, lineColor = {0, 0, 127}, fillColor = {255, 255, 255}, fillPattern = FillPattern.Solid)}));
  annotation (Documentation(info="<html>
<p>The counterparts of <code>Inputs</code>.</p>
</html>"));
end Outputs;
