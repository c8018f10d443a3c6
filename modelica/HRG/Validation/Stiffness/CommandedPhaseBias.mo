within HRG.Validation.Stiffness;
model CommandedPhaseBias "A commanded phase offset acts as a phase error of the demodulation"
  extends BaseClasses.BiasAtRest(
    gyro(resonator(material(frequencySplit = split, stiffnessAxis = axis)), phaseOffset = present*offset));
  parameter Units.AngularFrequency split = 2*Constants.pi*1e-3 "dw, of frequency";
  parameter Units.Angle axis = 0.5 "Of the mode of lower frequency";
  parameter Units.Angle offset = 1e-2 "Commanded";
equation
  measured = bias.rate;
  expected = -split*offset/(4*k)*sin(4*(theta - axis));
  scale = split*offset/(4*k);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>B = -(dw p/4k) sin 4(theta - theta_w), p commanded: the dither that tells mechanism 7 from 1.</p>
</html>"));
end CommandedPhaseBias;
