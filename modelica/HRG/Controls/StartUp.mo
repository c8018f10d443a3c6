within HRG.Controls;
block StartUp "Amplitude to aim at after power-on, and whether the output is valid"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.DimensionlessRatio firstAmplitude(min = 1e-3, max = 1) = 1
    "Share of the set point in the first stage, which gives a rate soon; 1: no start-up";
  parameter Units.Time firstTime(min = 0, max = 100) = 1 "End of the first stage";
  parameter Units.Time fullTime(min = 0.1, max = 1000) = 10 "Full amplitude is aimed at from here on";
  parameter Units.DimensionlessRatio amplitudeTolerance(min = 0, max = 1) = 0.2 "Of valid output, relative to the aim" annotation(Evaluate = false);
  parameter Units.Angle phaseTolerance(min = 0, max = 1) = 0.05 "Of valid output" annotation(Evaluate = false);
  parameter Units.DimensionlessRatio quadratureTolerance(min = 0, max = 1) = 0.05 "Of valid output, relative to the aim" annotation(Evaluate = false);
  parameter Units.Angle rebalanceTolerance(min = 0, max = 1) = 0.01 "Of valid output" annotation(Evaluate = false);
  input Units.RelativeDisplacement setpoint "Amplitude to hold in the end";
  input Units.RelativeDisplacement amplitude "Detected antinode amplitude";
  input Units.Angle phase "Detected phase";
  input Units.RelativeDisplacement quadratureError "Detected quadrature less its set point";
  input Units.Angle rebalanceError "Detected pattern angle less the one to hold, in the force-to-rebalance mode";
  input Units.DimensionlessRatio overload "1 while a drive is at its authority";
  discrete output Units.RelativeDisplacement aim(start = 1, fixed = true) "Amplitude to aim at now";
  discrete output Units.DampingCoefficient aimRate(start = 0, fixed = true) "Rate of the aim between the stages";
  discrete output Units.DimensionlessRatio isFar(start = 0, fixed = true) "1 while the amplitude is above twice the aim";
  discrete output Units.RelativeDisplacement error(start = 0, fixed = true)
    "Aim less amplitude; bounded above twice the aim, so that the amplitude doesn't fall through zero";
  discrete output Units.DimensionlessRatio valid(start = 0, fixed = true) "1 while all loops are within tolerance and no drive is overloaded";
protected
  discrete Units.Time clock(start = -samplePeriod, fixed = true) "Time since power-on";
equation
  when tick then
    clock = pre(clock) + samplePeriod;
    aim = setpoint*rampedShare(clock, firstAmplitude, firstTime, fullTime);
    aimRate = if clock < firstTime or clock >= fullTime then 0
      else setpoint*(1 - firstAmplitude)/(fullTime - firstTime);
    isFar = if amplitude > 2*aim then 1 else 0;
    error = if amplitude > 2*aim then -amplitude/2 else aim - amplitude;
    valid = if abs(amplitude - aim) <= amplitudeTolerance*aim and abs(phase) <= phaseTolerance
      and abs(quadratureError) <= quadratureTolerance*aim and abs(rebalanceError) <= rebalanceTolerance
      and overload < 0.5 then 1 else 0;
  end when;
  annotation (Documentation(info="<html>
<p>Two stages, after section 2.3 of the paper: a small vibration within a second, which already measures, then
the full amplitude within ten.</p>
</html>"));
end StartUp;
