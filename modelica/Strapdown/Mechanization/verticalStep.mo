within Strapdown.Mechanization;
function verticalStep "Height, velocity down and the height integral after a step"
  input Real now[3] "{height, m; velocity down, m/s; height integral, m.s} before it";
  input Real pushed[3] "{velocity change down without gravity, m/s; its mean, m/s; predicted height at the middle, m}";
  input Real gravity "Gravity at the middle, m/s2";
  input Real reference[3] "{height at the step's start and end, m; climb rate at its end, m/s} of the reference";
  input Real gains[3] "Feedback to height, velocity and integral, 1/s, 1/s2, 1/s3";
  input Real isClamped "1: height and climb rate are the reference's";
  input Real interval "Duration of the step, s";
  output Real result[3] "{height, m; velocity down, m/s; height integral, m.s} after it";
protected
  Real excess "Of the height over the reference at the middle, after half a step of the first feedback, m";
  Real gained "Velocity change by gravity and feedback, m/s";
algorithm
  excess := pushed[3] - 0.5*(reference[1] + reference[2]) - 0.5*interval*gains[1]*(now[1] - reference[1]);
  gained := interval*(gravity + (gains[2]*excess + gains[3]*(now[3] + 0.5*interval*excess)));
  result := if isClamped > 0.5 then {reference[2], -reference[3], 0} else {
    now[1] - interval*(now[2] + pushed[2] + 0.5*gained + gains[1]*excess),
    now[2] + pushed[1] + gained,
    now[3] + interval*excess};
  annotation (Documentation(info="<html>
<p>Eqs. 13 and 14.</p>
</html>"));
end verticalStep;
