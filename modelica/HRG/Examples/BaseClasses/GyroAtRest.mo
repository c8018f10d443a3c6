within HRG.Examples.BaseClasses;
model GyroAtRest "A gyro at rest on a bench; a modifier of an input puts something else in its place"
  extends Gyroscopes.HRGEnvelope(
    angularRate = 0,
    virtualRotation = 0,
    accelerationX = 0,
    accelerationY = 0,
    accelerationZ = 9.8,
    caseTemperature = 298.15,
    biasVoltage = 1,
    vibration = 0,
    amplitudeSetpoint = 1,
    phaseOffset = 0,
    driveOn = 1);
  annotation (Documentation(info="<html>
<p>Inputs of a gyro are bound to those of a bench at rest: no rate, no specific force, 25 degC, nominal voltage, drive on.</p>
</html>"));
end GyroAtRest;
