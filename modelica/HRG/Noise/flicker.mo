within HRG.Noise;
function flicker "One step of eight first-order lags whose weighted sum has a density of 1/f"
  input Real lags[8] "Lags with time constants 0.01 s times 8^0 to 8^7";
  input Real deviate "White noise of unit density over the control period";
  input Real samplePeriod "Control period";
  output Real result[8] "Next lags, each weighted for the sum";
protected
  Real timeConstant "Of a lag";
algorithm
  timeConstant := 0.01;
  for i in 1:8 loop
    result[i] := lags[i]*(1 - samplePeriod/timeConstant) + deviate*sqrt(samplePeriod/timeConstant);
    timeConstant := 8*timeConstant;
  end for;
  annotation (Documentation(info="<html>
<p>Lags tau/(1 + i w tau) of one white noise, spaced by a ratio r and weighted by tau^(-1/2), sum up to
(pi/ln r) (i w)^(-1/2): times ln 8/pi the sum has the two-sided density 1/(2 pi f) from 1e-5 to 10 Hz, within 5 %.
A bias instability B in the sense of IEEE Std 952 has B^2/(2 pi f).</p>
</html>"));
end flicker;
