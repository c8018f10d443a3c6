within HRG.Controls;
function sweptAngle "Angle of a sweep at a constant rate"
  input Units.Angle whole "Angle of the whole sweep";
  input Units.Time gone "Time since its begin; before it negative";
  input Units.Time sweepTime "Time for the whole sweep";
  output Units.Angle angle "0 before, the whole behind";
algorithm
  angle := if gone <= 0 then 0 elseif gone >= sweepTime then whole else whole*gone/sweepTime;
  annotation (Documentation(info="<html>
<p>A ramp from 0 to the whole angle.</p>
</html>"));
end sweptAngle;
