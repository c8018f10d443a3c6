within Strapdown.Mechanization;
function bodyStep "Rotation and velocity change over a step, in the body axes at its start"
  input Real rotation[6] "Two increments of rotation, rad";
  input Real velocity[6] "Two increments of velocity, m/s";
  output Real result[9] "{rotation vector, rad; velocity change by specific force, m/s; its mean over the step, m/s}";
protected
  Real firstTurn[3] "First increment of rotation";
  Real secondTurn[3] "Second increment of rotation";
  Real firstPush[3] "First increment of velocity";
  Real secondPush[3] "Second increment of velocity";
  Real turn[3] "Sum of the increments of rotation";
  Real push[3] "Sum of the increments of velocity";
  Real meanTurn[3] "Mean over the step of the rotation so far";
  Real meanPush[3] "Mean over the step of the velocity change so far";
  Real across[3] "First rotation x second velocity";
  Real back[3] "Second rotation x first velocity";
  Real coning[3] "Correction of the rotation vector";
  Real sculling[3] "Correction of the velocity change";
  Real scrolling[3] "Correction of its mean";
  Real once[3] "Rotation x velocity";
  Real twice[3] "Rotation x (rotation x velocity)";
  Real factors[3] "Eq. 4";
  Real turned[3] "Rotation vector";
  Real change[3] "Velocity change";
  Real mean[3] "Mean of the velocity change";
algorithm
  firstTurn := {rotation[1], rotation[2], rotation[3]};
  secondTurn := {rotation[4], rotation[5], rotation[6]};
  firstPush := {velocity[1], velocity[2], velocity[3]};
  secondPush := {velocity[4], velocity[5], velocity[6]};
  turn := firstTurn + secondTurn;
  push := firstPush + secondPush;
  meanTurn := 5/6*firstTurn + 1/6*secondTurn;
  meanPush := 5/6*firstPush + 1/6*secondPush;
  across := Algebra.vectorProduct(firstTurn, secondPush);
  back := Algebra.vectorProduct(secondTurn, firstPush);
  coning := 2/3*Algebra.vectorProduct(firstTurn, secondTurn);
  sculling := 2/3*(across - back);
  scrolling := 7/30*(Algebra.vectorProduct(firstTurn, firstPush) - back) + 1/10*(across - Algebra.vectorProduct(secondTurn, secondPush));
  once := Algebra.vectorProduct(turn, push);
  twice := Algebra.vectorProduct(turn, once);
  factors := rotationIntegrals(turn[1]*turn[1] + turn[2]*turn[2] + turn[3]*turn[3]);
  turned := turn + coning;
  change := push + sculling + slopeCorrection(turn, push, meanTurn, meanPush) + (factors[1]*once + factors[2]*twice);
  mean := meanPush + scrolling + (factors[2]*once + factors[3]*twice);
  result := {turned[1], turned[2], turned[3], change[1], change[2], change[3], mean[1], mean[2], mean[3]};
  annotation (Documentation(info="<html>
<p>Eqs. 1 to 4 for two increments (P. G. Savage, Strapdown inertial navigation integration algorithm design, Parts 1 and 2, JGCD 21 (1998)). Exact for
constant rate and force at any angle, with coning, sculling and scrolling terms. The coefficients are those that
<code>ins_eval/navigation/coefficients.py</code> derives for two increments; a test holds them to it.</p>
</html>"));
end bodyStep;
