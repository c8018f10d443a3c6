within Strapdown.Mechanization;
function slopeCorrection "Velocity change of second order in the angle and first order in the slopes of rate and force, m/s"
  input Real turn[3] "Rotation over the step, rad";
  input Real push[3] "Velocity change over the step, m/s";
  input Real meanTurn[3] "Mean over the step of the rotation so far, rad";
  input Real meanPush[3] "Mean over the step of the velocity change so far, m/s";
  output Real change[3] "Correction of the velocity change, m/s";
algorithm
  change := 0.25*(Algebra.vectorProduct(turn, Algebra.vectorProduct(turn, push - 2*meanPush))
    - Algebra.vectorProduct(turn - 2*meanTurn, Algebra.vectorProduct(turn, push)));
  annotation (Documentation(info="<html>
<p>Eq. 5.</p>
</html>"));
end slopeCorrection;
