within HRG.Resonators;
model Envelope "Slowly varying envelope of the two n = 2 modes"
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at time 0";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  input Units.DampingCoefficient dampingX "Damping of x";
  input Units.DampingCoefficient dampingY "Damping of y";
  input Units.DampingCoefficient dampingSin "Damping between x and y";
  input Units.DampingCoefficient pumping[3] "Growth by parametric drive of x, of y and between them, in phase with the reference";
  input Units.AngularFrequency shift "Mean frequency above the nominal one";
  input Units.AngularFrequency splitCos "Stiffness anisotropy, diagonal";
  input Units.AngularFrequency splitSin "Stiffness anisotropy, off diagonal";
  input Units.AngularVelocity coupling "Bryan coupling of the modes, n k Omega with n = 2";
  input Units.AngularFrequency duffing "Frequency shift at unit amplitude by cubic stiffness";
  input Units.AngularFrequency cubic "Softening of x and of y at unit amplitude of their own";
  input Units.AngularFrequency reference "Frequency of the rotating frame above the nominal one";
  input Units.RelativeForce force[4] "Forces on the envelope, {cos x, sin x, cos y, sin y}";
  output Units.RelativeDisplacement displacement[4](
    start = {startAmplitude*cos(2*startAngle), 0, startAmplitude*sin(2*startAngle), 0},
    each fixed = true) "In-phase and quadrature displacement {cx, sx, cy, sy}";
equation
  der(displacement) = envelopeRates(
    displacement, {dampingX - pumping[1], dampingY - pumping[2], dampingSin - pumping[3]},
    {dampingX + pumping[1], dampingY + pumping[2], dampingSin + pumping[3]},
    reference - shift, splitCos, splitSin, coupling, duffing, cubic) + force;
  annotation (Documentation(info="<html>
<p>Z' = (free envelope) + U + R Z*, U the force as a growth of the envelope, U = -(i/2w) F, and R = <code>pumping</code> the growth by a stiffness
that is modulated at twice the reference frequency: what is in phase with the reference grows by it, what is in quadrature decays. Without the Duffing term it is
linear, so that a step of a control period loses nothing.</p>
</html>"));
end Envelope;
