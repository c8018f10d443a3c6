within HRG.Controls;
function kalmanUpdate "States and their covariance after a scalar reading, whose weight is limited"
  input Real before[91] "{nine states, the prior's covariance less theirs, row by row}; that of the prior is the identity; the last innovation";
  input Real reading[10] "{sensitivities to the states, value}";
  input Real noise "Standard deviation of the reading";
  output Real result[91] "The same after the reading, and the innovation over its standard deviation";
protected
  Real spread[9] "Covariance of the states with the reading";
  Real innovation "Value less the expected one";
  Real variance "Of the innovation";
algorithm
  innovation := reading[10];
  variance := noise*noise;
  for i in 1:9 loop
    spread[i] := reading[i];
    for j in 1:9 loop
      spread[i] := spread[i] - before[9*i + j]*reading[j];
    end for;
    innovation := innovation - reading[i]*before[i];
    variance := variance + reading[i]*spread[i];
  end for;
  variance := if innovation*innovation > 9*variance then innovation*innovation/9 else variance;
  for i in 1:9 loop
    result[i] := before[i] + spread[i]*innovation/variance;
    for j in 1:9 loop
      result[9*i + j] := before[9*i + j] + spread[i]*spread[j]/variance;
    end for;
  end for;
  result[91] := innovation/sqrt(variance);
  annotation (Documentation(info="<html>
<p>The Kalman filter of constant states for one reading. An innovation beyond three standard deviations counts as one of a noise that puts it there (Huber 1981, section 7.3). The
covariance that readings took away, and not what they left, is kept: it begins at zero.</p>
</html>"));
end kalmanUpdate;
