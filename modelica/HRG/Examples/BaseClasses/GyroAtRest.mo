within HRG.Examples.BaseClasses;
model GyroAtRest "A gyro at rest on a bench; a modifier of an input puts something else in its place"
  extends Gyroscopes.HRG(
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
end GyroAtRest;
