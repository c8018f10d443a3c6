within HRG.Controls;
function mapChange "Change of the bias map by eight states"
  input Units.AngularVelocity expected[3] "Expected change {mean, cos 4 theta, sin 4 theta}";
  input Units.AngularVelocity map[24] "Change per state, all states of a coefficient side by side";
  input Real estimate[72] "States, as of kalmanUpdate()";
  output Units.AngularVelocity change[3] "{mean, cos 4 theta, sin 4 theta}";
algorithm
  for h in 1:3 loop
    change[h] := expected[h];
    for s in 1:8 loop
      change[h] := change[h] + map[8*h - 8 + s]*estimate[s];
    end for;
  end for;
  annotation (Documentation(info="<html>
<p>Linear in the states.</p>
</html>"));
end mapChange;
