within HRG.Validation.BaseClasses;
partial model Claim "A gyro, and one measured quantity beside its closed form"
  replaceable model Gyro = Gyroscopes.HRGEnvelope "Kind of gyro under test";
  replaceable type Quantity = Real "What is measured";
  parameter Units.Angle startAngle(min = -1000, max = 1000) = 0.1 "Pattern angle at power-on";
  parameter Integer present(min = 0, max = 1) = 1 "1: with the mechanism; 0: without it, the negative control";
  parameter Units.Time controlPeriod = 1e-3 "Ts, for which the electronics hold their forces";
  parameter Units.DimensionlessRatio tolerance(min = 0, max = 1) = 2e-3 "Of the difference at the stop time, relative to the scale";
  final parameter Units.DimensionlessRatio k = gyro.resonator.material.bryanFactor "Bryan factor";
  final parameter Units.Time tau = gyro.resonator.material.decayTime "Decay time";
  output Quantity measured "Measured; zero without the mechanism";
  output Quantity expected "Closed form";
  output Quantity scale "Size of the effect";
  Gyro gyro(
    startAngle = startAngle,
    angularRate = 0,
    virtualRotation = 0,
    accelerationX = 0,
    accelerationY = 0,
    accelerationZ = 0,
    caseTemperature = 298.15,
    biasVoltage = 1,
    vibration = 0,
    amplitudeSetpoint = 1,
    phaseOffset = 0,
    driveOn = 1) "Gyro under test";
protected
  final parameter Units.DimensionlessRatio holdError = -controlPeriod/2/tau
    "Scale-factor error of held forces: a claim of its own, Electronics.HoldLag";
  Units.Angle theta = gyro.patternAngle "Pattern angle";
  annotation (Documentation(info="<html>
<p>At the stop time |measured - expected| &le; tolerance scale must hold, whatever the start angle; without the mechanism
(<code>present = 0</code>) |measured| &le; tolerance scale. <code>expected</code> and <code>scale</code> are closed forms of
parameters, and of the pattern angle where the claim is a harmonic of it.</p>
</html>"));
end Claim;
