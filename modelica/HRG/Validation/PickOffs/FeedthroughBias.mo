within HRG.Validation.PickOffs;
model FeedthroughBias "Feedthrough c of the drive with a frequency split dw: a bias of (c dw^2/8k) sin 8 theta"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(material(frequencySplit = split)), pickOff(feedthrough = present*feedthrough)));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Time feedthrough = 1e-3 "c, displacement read over force";
equation
  measured = bias.rate;
  expected = feedthrough*split^2/(8*k)*sin(8*theta);
  scale = feedthrough*split^2/(8*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The quadrature force (dw/2) sin 4 theta, read as quadrature, leaves -c (dw/2) sin 4 theta of it standing, and by
mechanism 8 the pattern drifts: B = (c dw^2/4k) sin 4 theta cos 4 theta, x being the axis of lower frequency.
Mechanism 11.</p>
</html>"));
end FeedthroughBias;
