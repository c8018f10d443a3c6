within HRG.Validation.Electronics;
model BryanFactor "A Bryan factor off by e: a scale-factor error of e"
  extends BaseClasses.Turning(gyro(resonator(material(bryanFactor = 0.277*(1 + present*relativeError)))));
  parameter Units.DimensionlessRatio relativeError = 20e-6 "e, true over believed, less one";
equation
  measured = angleError;
  expected = relativeError*caseAngle;
  scale = abs(relativeError)*caseAngle;
  annotation (experiment(StopTime = 50), Documentation(info="<html>
<p>Mechanism 16: the angle of the case is the pattern's over the k that the electronics believe, 0.277.</p>
</html>"));
end BryanFactor;
