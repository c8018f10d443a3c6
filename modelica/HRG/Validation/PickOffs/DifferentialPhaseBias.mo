within HRG.Validation.PickOffs;
model DifferentialPhaseBias "Differential phase p with a frequency split dw: a bias at the eighth harmonic, (dw p/16k) sin 8 theta"
  extends BaseClasses.BiasAtRest(
    tolerance = 0.01,
    gyro(resonator(material(frequencySplit = split)), pickOff(differentialPhase = present*phase)));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle phase = 1e-2 "p, of x against y";
equation
  measured = bias.rate;
  expected = split*phase/(16*k)*sin(8*theta);
  scale = split*phase/(16*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>With x turned by p/2 and y by -p/2, the loops settle at a phase error of (p/2) cos 4 theta and a quadrature of
-(p/2) sin 4 theta. By mechanisms 7 and 8 these give -(dw p/8k) cos 4 theta sin 4 theta + (dw p/4k) sin 4 theta cos 4
theta = (dw p/16k) sin 8 theta, x being the axis of lower frequency. Mechanism 10.</p>
</html>"));
end DifferentialPhaseBias;
