within Strapdown.Mechanization;
function axesTurn "Rotation of the navigation axes over a step, and the Coriolis velocity change"
  input Real average[3] "Mean velocity in axes that do not turn, m/s";
  input Real change[3] "Velocity change by specific force, m/s";
  input Real place[7] "Of function middle";
  input Real interval "Duration of the step, s";
  input Real isClamped "1: the height reference gives the mean vertical velocity";
  output Real result[6] "{rotation, rad; Coriolis velocity change, m/s}";
protected
  Real earth[3] "Rate of Earth, rad/s";
  Real transport[3] "Transport rate, rad/s";
  Real mean[3] "Mean velocity, m/s";
  Real turn[3] "Rotation, rad";
  Real coriolis[3] "Coriolis velocity change, m/s";
  Real bend[3] "What the axes' turning and Coriolis change in the mean velocity, m/s";
algorithm
  earth := {Earth.rate*place[2], 0, -Earth.rate*place[1]};
  mean := average;
  for pass in 1:2 loop
    transport := transportRate(mean, place);
    turn := interval*(earth + transport);
    coriolis := -interval*Algebra.vectorProduct(2*earth + transport, mean);
    bend := 0.5*coriolis - 1/6*Algebra.vectorProduct(turn, change);
    mean := {average[1] + bend[1], average[2] + bend[2], if isClamped > 0.5 then average[3] else average[3] + bend[3]};
  end for;
  result := {turn[1], turn[2], turn[3], coriolis[1], coriolis[2], coriolis[3]};
  annotation (Documentation(info="<html>
<p>Two passes of Eqs. 10 and 11 (Groves 2013, Eq. 5.54).</p>
</html>"));
end axesTurn;
