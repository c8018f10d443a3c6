within HRG.Resonators;
partial model PartialDrivenResonator "Vibrating shell under forces that are held for a control period"
  extends PartialResonator(final thermalPeriod = 10*samplePeriod, final thermalTick = thermal.tick);
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  Interfaces.Inputs.AngularFrequency reference "Frequency of the reference above the nominal one"
    annotation (Placement(transformation(extent = {{-120, -48}, {-100, -28}})));
  Interfaces.Inputs.RelativeForce force[4] "Drive forces {cos x, sin x, cos y, sin y}"
    annotation (Placement(transformation(extent = {{-120, -98}, {-100, -78}})));
  Interfaces.Inputs.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them"
    annotation (Placement(transformation(extent = {{-120, -72}, {-100, -52}})));
  Interpolation interpolation(
    samplePeriod = samplePeriod,
    tick = tick,
    thermalPeriod = thermalPeriod,
    thermalTick = thermalTick,
    startTemperature = environment.startTemperature,
    temperature = environment.temperature,
    gradient = environment.gradient) "Temperatures between their samples";
protected
  Controls.ClockDivider thermal(final factor = 10, clock = tick) "Samples of temperature";
  annotation (Documentation(info="<html>
<p>The environment is sampled every tenth control period; between its samples the pick-offs follow straight lines.</p>
</html>"));
end PartialDrivenResonator;
