within HRG.Controls;
function mapChange "Change of the bias map by nine states"
  input Units.AngularVelocity expected[3] "Expected change {mean, cos 4 theta, sin 4 theta}";
  input Units.AngularVelocity map[27] "Change per state, all states of a coefficient side by side";
  input Real estimate[91] "States, as of kalmanUpdate()";
  input Units.DimensionlessRatio followed "1; 0 if the states are not to be followed";
  output Units.AngularVelocity change[3] "{mean, cos 4 theta, sin 4 theta}";
algorithm
  for h in 1:3 loop
    change[h] := expected[h];
    for s in 1:9 loop
      change[h] := change[h] + followed*map[9*h - 9 + s]*estimate[s];
    end for;
  end for;
  annotation (Documentation(info="<html>
<p>Linear in the states. Where they are not followed, the expected change is left.</p>
</html>"));
end mapChange;
