within HRG.Controls;
block EstimatingController "Controller that estimates the change of its bias map from the amplitude force, and takes it out of the output"
  extends Controller(readout(correction = biasMap.correction + estimator.correction));
  MapEstimator estimator(
    samplePeriod = samplePeriod,
    tick = tick,
    bryanFactor = readout.bryanFactor,
    cosine = detector.cosine,
    sine = detector.sine,
    growthRate = synthesis.drivenGrowth,
    frequencyOffset = frequencyOffset,
    virtualRotation = commandedTurn/(2*readout.bryanFactor),
    valid = startUp.valid*driveOn*(1 - forceToRebalance)) "Change of the bias map";
  Interfaces.Outputs.Switch mapFollowed = estimator.followed "1 while the estimated change of the bias map is taken out"
    annotation (Placement(transformation(extent = {{100, -100}, {112, -88}})));
  annotation (Documentation(info="<html>
<p>As <code>Controller</code>, with a <code>MapEstimator</code> beside its <code>BiasMap</code>. Compensation of the output alone: forces and pattern are those of <code>Controller</code> to the bit.</p>
</html>"));
end EstimatingController;
