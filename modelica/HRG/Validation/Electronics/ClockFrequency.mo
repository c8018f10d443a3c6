within HRG.Validation.Electronics;
model ClockFrequency "A clock fast by e: the modal frequency w is counted low by e w"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.AngularFrequency,
    gyro(controller(readout(clockError = present*excess))));
  parameter Units.DimensionlessRatio excess = 1e-4 "e, of the clock";
equation
  measured = gyro.frequencyOffset;
  expected = -excess*gyro.resonator.material.frequency;
  scale = excess*gyro.resonator.material.frequency;
  annotation (experiment(StopTime = 5), Documentation(info="<html>
<p>P = -e w: mechanism 17.</p>
</html>"));
end ClockFrequency;
