within HRG.Noise;
function flicker "One step of eight first-order lags whose sum has a density of 1/f"
  input Real lags[8] "Lags";
  input Real decays[16] "As of lagDecays()";
  input Real deviate "White noise of variance 1";
  output Real result[8] "Next lags";
algorithm
  for i in 1:8 loop
    result[i] := lags[i]*decays[i] + deviate*decays[8 + i];
  end for;
  annotation (Documentation(info="<html>
<p>Lags tau/(1 + i w tau) of one white noise, spaced by a ratio r and weighted by tau^(-1/2), sum up to
(pi/ln r) (i w)^(-1/2): times ln 8/pi the sum has the two-sided density 1/(2 pi f) from 3e-4 to 0.3 Hz, within 8 %.
A bias instability B in the sense of IEEE Std 952 has B^2/(2 pi f).</p>
</html>"));
end flicker;
