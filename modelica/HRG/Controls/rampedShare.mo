within HRG.Controls;
function rampedShare "Share of the full amplitude: a first stage, then a straight line to 1"
  input Real clock "Time since power-on";
  input Real firstShare "Share in the first stage";
  input Real firstTime "Its end";
  input Real fullTime "When 1 is reached";
  output Real share "Share";
algorithm
  share := if clock >= fullTime then 1
    elseif clock <= firstTime then firstShare
    else firstShare + (1 - firstShare)*(clock - firstTime)/(fullTime - firstTime);
  annotation (Documentation(info="<html>
<p>The first share until the first time, 1 from the full time on, linear between.</p>
</html>"));
end rampedShare;
