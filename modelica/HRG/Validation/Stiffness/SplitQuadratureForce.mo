within HRG.Validation.Stiffness;
model SplitQuadratureForce "Frequency split dw: a quadrature force of (dw/2) sin 4(theta - theta_w)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeForce,
    gyro(resonator(material(frequencySplit = present*split, stiffnessAxis = axis))));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
equation
  measured = gyro.quadratureForce;
  expected = split/2*sin(4*(theta - axis));
  scale = split/2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>N = (dw/2) sin 4(theta - theta_w): the split turns amplitude into quadrature at this rate, and the loop holds
against it. Mechanism 9; dQ/dt of Lynch's averaged equations.</p>
</html>"));
end SplitQuadratureForce;
