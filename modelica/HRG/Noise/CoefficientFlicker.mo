within HRG.Noise;
block CoefficientFlicker "Flicker of damping anisotropy, of the pick-offs' gain mismatch and of their phase"
  parameter Units.Time samplePeriod "Period of the noise";
  Boolean tick = sample(0, samplePeriod) "Each sample period";
  parameter Integer seed(min = 0, max = 2147483647) "Seed of the generators";
  parameter Units.DimensionlessRatio dampingAnisotropy(min = 0, max = 1) = 0
    "Flicker coefficient of D relative to it, typically 1e-5 to 1e-3 (estimate): 4e-5 to 4e-3 deg/h where D makes 4 deg/h";
  parameter Units.DimensionlessRatio gainMismatch(min = 0, max = 0.1) = 0
    "Flicker coefficient of g, typically 1e-7 to 1e-6 (estimate): 0.02 to 0.2 arcsec of angle, and 4e-5 to 4e-4 deg/h at a decay time of 450 s";
  parameter Units.Angle phaseError(min = 0, max = 0.1) = 0
    "Flicker coefficient of p, typically 1e-7 to 1e-6 (estimate): 6e-5 to 6e-4 deg/h under a split of 0.5 mHz";
  Interfaces.Outputs.DimensionlessRatio damping "Relative change of the damping anisotropy"
    annotation (Placement(transformation(extent = {{100, -77}, {120, -57}})));
  Interfaces.Outputs.DimensionlessRatio gain "Change of the gain mismatch"
    annotation (Placement(transformation(extent = {{100, 57}, {120, 77}})));
  Interfaces.Outputs.Angle phase "Change of the phase"
    annotation (Placement(transformation(extent = {{100, -10}, {120, 10}})));
protected
  final parameter Units.DimensionlessRatio start[45] = seededFlickers(seed) "Memory at time 0";
  final parameter Units.DimensionlessRatio scale = 2.0794415416798357/Constants.pi "Of a sum of lags, ln 8/pi";
  final parameter Units.DimensionlessRatio isMade = if dampingAnisotropy > 0 or gainMismatch > 0 or phaseError > 0 then 1 else 0
    "1 where there is any flicker: else nothing is drawn for it";
  final parameter Units.DimensionlessRatio decays[16] = lagDecays(samplePeriod) "Of the lags over a period, and weights of their input";
  discrete Units.DimensionlessRatio memory[45](start = start, each fixed = true) "States of the generators, lags and their sums";
equation
  when tick then
    memory = if isMade > 0.5 then flickers(pre(memory), decays) else pre(memory);
  end when;
  damping = dampingAnisotropy*scale*memory[43];
  gain = gainMismatch*scale*memory[44];
  phase = phaseError*scale*memory[45];
  annotation (Icon(graphics = {Rectangle(extent = {{-100, 100}, {100, -100}}), Line(points = {{-80, -20}, {-50, 10}, {-30, -10}, {0, 40}, {30, 20}, {50, 50}, {80, 30}}), Text(extent = {{-150, 140}, {150, 105}}, textString = "%name", textColor = {0, 0, 255})}),
    Documentation(info="<html>
<p>Each is the sum of <code>flickers</code>, scaled to its coefficient, in the sense of <code>ElectronicsNoise</code>: of coefficient B, it has the density B^2/(2 pi f) and
an Allan deviation of 0.664 B. Its generators start from the gyro's seed by a hash of their own, so that they are unrelated to those of <code>ElectronicsNoise</code>. These coefficients
move in minutes, so that a period of 10 ms is fine for them. Mechanism 38: the bias flickers as these coefficients make it, with the pattern angle, where
<code>noise.biasInstability</code> is alike at all of them.</p>
</html>"));
end CoefficientFlicker;
