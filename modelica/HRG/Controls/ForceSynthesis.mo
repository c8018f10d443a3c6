within HRG.Controls;
block ForceSynthesis "Loop commands, resolved from the pattern's axes into the electrodes'"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Angle startAngle "Pattern angle at time 0";
  parameter Units.Time loopDelay(min = 0, max = 0.1) = 0
    "Age of the angle that forces are resolved with, beyond the sample, typically up to 1e-3";
  parameter Units.DimensionlessRatio parametricShare "Share of the force on the antinode that parametric drive gives";
  parameter Integer timeDivision "1: the electrodes drive in one control period and sense in the next; 0: they do both at once";
  input Units.DimensionlessRatio driveShare "Force until the next sample over its mean";
  input Units.Angle patternAngle "Detected pattern angle";
  input Units.DimensionlessRatio cosine "Of the detected modal angle";
  input Units.DimensionlessRatio sine "Of the detected modal angle";
  input Units.RelativeDisplacement amplitude "Detected antinode amplitude";
  input Units.RelativeForce antinodeForce "Command of the amplitude loop";
  input Units.RelativeForce quadratureForce "Command of the quadrature loop";
  input Units.AngularVelocity patternRate "Commanded rotation of the pattern";
  input Units.DimensionlessRatio driveOn "1 with the drive on, 0 off";
  input Units.RelativeForce authority "A channel of the drives gives no more than this force; 0: no limit";
  discrete output Units.RelativeForce force[4](each start = 0, each fixed = true) "Force until the next sample {cos x, sin x, cos y, sin y}";
  discrete output Units.RelativeForce acting[4](each start = 0, each fixed = true) "Force that was held up to the sample";
  discrete output Units.DampingCoefficient drivenGrowth(start = 0, fixed = true) "Force on the antinode over its amplitude";
  discrete output Units.DampingCoefficient pump(start = 0, fixed = true) "Growth by parametric drive until the next sample";
  discrete output Units.RelativeForce square(start = 0, fixed = true) "Force on the node, in phase with the displacement";
  discrete output Units.DimensionlessRatio overloaded(start = 0, fixed = true) "1 while a channel is at its limit";
  discrete output Units.DimensionlessRatio wasOverloaded(start = 0, fixed = true) "The same at the last sample";
  discrete output Units.AngularVelocity lostRate(start = 0, fixed = true) "Pattern rate that the limit takes away";
protected
  discrete Units.RelativeForce wanted[4](each start = 0, each fixed = true) "Mean force without a limit {cos x, sin x, cos y, sin y}";
  discrete Units.RelativeForce bounded[4](each start = 0, each fixed = true) "The same within the authority, in the mean";
  discrete Units.Angle lastAngle(start = startAngle, fixed = true) "Pattern angle at the last sample";
  discrete Units.Angle lag(start = 0, fixed = true) "Modal angle by which the forces lag";
  discrete Units.DimensionlessRatio lagCosine(start = 1, fixed = true) "Of the lag, to fourth order";
  discrete Units.DimensionlessRatio lagSine(start = 0, fixed = true) "Of the lag, to fourth order";
  discrete Units.DimensionlessRatio c(start = 1, fixed = true) "Of the modal angle of the forces";
  discrete Units.DimensionlessRatio s(start = 0, fixed = true) "Of the modal angle of the forces";
  discrete Units.RelativeForce antinode(start = 0, fixed = true) "Force on the antinode, in phase with the velocity, that electrodes give";
  discrete Units.RelativeForce node(start = 0, fixed = true) "Force on the node, in phase with the velocity";
equation
  when tick then
    acting = pre(force);
    lastAngle = patternAngle;
    lag = loopDelay*2*(patternAngle - pre(lastAngle))/(samplePeriod*(1 + timeDivision));
    lagCosine = 1 - lag*lag/2;
    lagSine = lag - lag*lag*lag/6;
    c = cosine*lagCosine + sine*lagSine;
    s = sine*lagCosine - cosine*lagSine;
    drivenGrowth = driveOn*antinodeForce/amplitude;
    pump = driveShare*(parametricShare*drivenGrowth);
    antinode = (1 - parametricShare)*(driveOn*antinodeForce);
    node = driveOn*2*patternRate*amplitude;
    square = driveOn*quadratureForce;
    wanted = {antinode*c - node*s, -square*s, antinode*s + node*c, square*c};
    bounded = {
      Electrodes.digitised(wanted[1], 0, authority/(1 + timeDivision)),
      Electrodes.digitised(wanted[2], 0, authority/(1 + timeDivision)),
      Electrodes.digitised(wanted[3], 0, authority/(1 + timeDivision)),
      Electrodes.digitised(wanted[4], 0, authority/(1 + timeDivision))};
    force = {driveShare*bounded[1], driveShare*bounded[2], driveShare*bounded[3], driveShare*bounded[4]};
    wasOverloaded = pre(overloaded);
    overloaded = if abs(wanted[1] - bounded[1]) + abs(wanted[2] - bounded[2]) + abs(wanted[3] - bounded[3])
      + abs(wanted[4] - bounded[4]) > 0 then 1 else 0;
    lostRate = if overloaded > 0.5 then (node - bounded[3]*c + bounded[1]*s)/(driveOn*2*amplitude) else 0;
  end when;
  annotation (Documentation(info="<html>
<p>With A on the antinode, N on the node and S on the node in quadrature, c and s of the modal angle,</p>
<pre>force = {A c - N s, -S s, A s + N c, S c}</pre>
<p>{cos x, sin x, cos y, sin y}, as growths of the envelope. For an orbit without quadrature a' = A, q' = S and theta' = N/(2 a), so that
N = 2 a times the commanded rate of the pattern. Forces are held for a control period; the loop delay turns
their axes back by the pattern's way in it (mechanism 15). A channel is clipped at the drives' authority (mechanism 30); the rotation that this
takes away, (N - force along the node)/(2 a), is told to the read-out. Of A, parametric drive
gives its share as a growth, A/a, of the antinode wherever it is: that share has no axes to be turned, delayed or clipped. In time division the force acts in every second period, twice as large (mechanism 40). Control by antinode and node forces: D. D. Lynch.</p>
</html>"));
end ForceSynthesis;
