within HRG.Validation.Stiffness;
model SplitFrequency "Frequency split dw: a frequency of -(dw/2) cos 4(theta - theta_w)"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(resonator(material(frequencySplit = present*split, stiffnessAxis = axis))));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
equation
  measured = gyro.frequencyOffset;
  expected = -split/2*cos(4*(theta - axis));
  scale = split/2;
  annotation (experiment(StopTime = 10), Documentation(info="<html>
<p>P = -(dw/2) cos 4(theta - theta_w): lowest along theta_w. Mechanism 9; dphi/dt of Lynch's averaged equations.</p>
</html>"));
end SplitFrequency;
