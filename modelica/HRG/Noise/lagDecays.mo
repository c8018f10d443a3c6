within HRG.Noise;
function lagDecays "Decay of the flicker noise's lags over a period, and the weights of their input"
  input Real samplePeriod "Period";
  output Real result[16] "Eight decays, of lags with time constants 0.01 s times 8^0 to 8^7, and eight weights";
protected
  Real timeConstant "Of a lag";
algorithm
  timeConstant := 0.01;
  for i in 1:8 loop
    result[i] := exp(-samplePeriod/timeConstant);
    result[8 + i] := (1 - result[i])*sqrt(timeConstant/samplePeriod);
    timeConstant := 8*timeConstant;
  end for;
  annotation (Documentation(info="<html>
<p>A lag of time constant t keeps d = exp(-period/t) of its value and takes (1 - d) sqrt(t/period) of its input, for <code>flicker</code>.</p>
</html>"));
end lagDecays;
