within HRG.Validation.Modes;
model PatternDither "Dither of the pattern over a whole period of the map: fourth and eighth harmonics average out"
  extends BaseClasses.BiasAtRest(
    bias(begin = 2*sweepTime),
    gyro(
      resonator(material(dampingAnisotropy = anisotropy, dampingAxis = axis)),
      controller(
        biasMap(sin8 = -eighth),
        sweep(angle = present*Constants.pi/2, sweepTime = sweepTime))));
  parameter Units.DampingCoefficient anisotropy = 1e-6 "D, of damping";
  parameter Units.Angle axis = 0.35 "Of maximum damping";
  parameter Units.AngularVelocity eighth = 3e-7 "Eighth harmonic of the output";
  parameter Units.Time sweepTime = 20 "t_s";
protected
  Units.AngularVelocity still "Bias without dither";
equation
  still = eighth*sin(8*startAngle) - anisotropy/(4*k)*sin(4*(startAngle - axis));
  measured = bias.rate - still;
  expected = -still;
  scale = anisotropy/(4*k);
  annotation (experiment(StopTime = 80), Documentation(info="<html>
<p>A triangle of 90 degrees, in the whole-angle mode: the time at all angles is the same, and nothing is left of harmonics 4, 8, 12.</p>
</html>"));
end PatternDither;
