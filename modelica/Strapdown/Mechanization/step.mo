within Strapdown.Mechanization;
function step "State of the navigator after a step"
  input Real state[17] "{latitude, longitude, rad; height, m; velocity north, east, down, m/s; attitude (4); height integral, m.s; rounding errors of latitude, longitude, attitude (4)}";
  input Real rotation[6] "Two increments of rotation in body axes, rad";
  input Real velocity[6] "Two increments of velocity in body axes, m/s";
  input Real interval "Duration of the step, s";
  input Real reference[3] "{height at the step's start and end, m; climb rate at its end, m/s} of the reference";
  input Real gains[3] "Feedback to height, velocity and height integral, 1/s, 1/s2, 1/s3";
  input Real isClamped "1: height and climb rate are the reference's";
  output Real result[17] "The same after the step";
protected
  Real q[4] "Attitude";
  Real body[9] "Of function bodyStep";
  Real change[3] "Velocity change by specific force, in turning axes with what is added level, m/s";
  Real mean[3] "Its mean over the step, m/s";
  Real average[3] "Mean velocity in axes that do not turn, m/s";
  Real place[7] "Of function middle";
  Real axes[6] "Of function axesTurn";
  Real turn[3] "Rotation of the navigation axes, rad";
  Real crossed[3] "That rotation x velocity change, m/s";
  Real pulled[3] "Velocity change by Coriolis and level gravity, m/s";
  Real vertical[3] "Of function verticalStep";
  Real sums[2] "A sum and its rounding error";
  Real turned[4] "Change of the attitude";
algorithm
  q := {state[7], state[8], state[9], state[10]};
  body := bodyStep(rotation, velocity);
  change := Algebra.rotate(q, {body[4], body[5], body[6]});
  mean := Algebra.rotate(q, {body[7], body[8], body[9]});
  average := {
    state[4] + mean[1] + 0.5*interval*Earth.northGravity(state[1], state[3]),
    state[5] + mean[2],
    if isClamped > 0.5 then (reference[1] - reference[2])/interval
    else state[6] + mean[3] + 0.5*interval*Earth.gravity(state[1], state[3])};
  place := middle(state[1], state[3], average, interval);
  axes := axesTurn(average, change, place, interval, isClamped);
  turn := {axes[1], axes[2], axes[3]};
  crossed := Algebra.vectorProduct(turn, change);
  pulled := {axes[4] + interval*place[7], axes[5], axes[6]};
  change := change - Algebra.vectorProduct(turn, change - mean) + 1/6*Algebra.vectorProduct(turn, crossed) + pulled;
  mean := mean - 1/6*crossed + 0.5*pulled;
  sums := Algebra.compensated(state[1], state[12], interval*(state[4] + mean[1])/place[4]);
  result[1] := sums[1];
  result[12] := sums[2];
  sums := Algebra.compensated(state[2], state[13], interval*(state[5] + mean[2])/(place[5]*place[2]));
  result[2] := sums[1];
  result[13] := sums[2];
  vertical := verticalStep({state[3], state[6], state[11]}, {change[3], mean[3], place[3]}, place[6], reference, gains, isClamped, interval);
  result[3] := vertical[1];
  result[4] := state[4] + change[1];
  result[5] := state[5] + change[2];
  result[6] := vertical[2];
  result[11] := vertical[3];
  turned := attitudeChange(q, {body[1], body[2], body[3]}, turn);
  for i in 1:4 loop
    sums := Algebra.compensated(q[i], state[13 + i], turned[i]);
    result[6 + i] := sums[1];
    result[13 + i] := sums[2];
  end for;
  annotation (Documentation(info="<html>
<p>Eqs. 10 to 16: the result of <code>bodyStep</code> in navigation axes. Earth's rate, transport rate, Coriolis acceleration and gravity belong to
the middle of the step, which follows from its mean velocity.</p>
</html>"));
end step;
