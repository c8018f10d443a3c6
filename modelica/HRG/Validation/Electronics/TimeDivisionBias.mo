within HRG.Validation.Electronics;
model TimeDivisionBias "Drive and sense in time division with a frequency split dw: a bias of -(dw^2 Ts/16k) sin 8 theta"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(material(frequencySplit = split)), controller(timeDivision = present)));
  parameter Units.AngularFrequency split = 2*Constants.pi*5e-3 "dw, of frequency";
equation
  measured = bias.rate;
  expected = -split^2*controlPeriod/(16*k)*sin(8*theta);
  scale = split^2*controlPeriod/(16*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>The quadrature force (dw/2) sin 4 theta acts twice as large in every second period. Quadrature grows in it to Ts times the force, and is back at zero, where it is
sensed, a period later: in the mean Ts/2 times the force. By mechanism 8 the pattern drifts, as with a feedthrough of -Ts/2 (mechanism 11), x being the axis of lower
frequency. Mechanism 40.</p>
</html>"));
end TimeDivisionBias;
