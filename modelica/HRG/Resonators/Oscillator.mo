within HRG.Resonators;
model Oscillator "The two n = 2 modes at their carrier frequency"
  parameter Units.AngularFrequency frequency "Nominal modal frequency";
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
  input Units.AngularFrequency reference "Frequency of the reference oscillator above the nominal one";
  input Units.RelativeForce force[4] "Modulation of the drive, {cos x, sin x, cos y, sin y}, as a growth of the envelope";
  output Units.RelativeDisplacement position[2](
    start = {startAmplitude*cos(2*startAngle), startAmplitude*sin(2*startAngle)},
    each fixed = true) "Displacement {x, y}";
  output Units.DimensionlessRatio carrier[2](start = {1, 0}, each fixed = true) "Cosine and sine of the reference oscillator's phase";
protected
  Real momentum[2](each unit = "1/s", each start = 0, each fixed = true) "Velocity as an observer at rest sees it";
  Real velocity[2](each unit = "1/s") "Velocity in the turning case";
  Units.AngularFrequency modal "Mean modal frequency";
  Real stiffness(unit = "1/s2") "Squared frequency, the cubic term included";
  Real drive[2](each unit = "1/s2") "Modal acceleration by the drive";
  Real wave "Twice the sine of twice the reference oscillator's phase";
equation
  der(carrier) = {-(frequency + reference)*carrier[2], (frequency + reference)*carrier[1]};
  modal = frequency + shift;
  stiffness = modal^2 + 8/3*modal*duffing*(position[1]^2 + position[2]^2);
  drive = {
    2*modal*(force[2]*carrier[1] - force[1]*carrier[2]),
    2*modal*(force[4]*carrier[1] - force[3]*carrier[2])};
  wave = 4*carrier[1]*carrier[2];
  velocity = {momentum[1] + coupling*position[2], momentum[2] - coupling*position[1]};
  der(position) = velocity;
  der(momentum) = {
    coupling*velocity[2] - 2*(dampingX*velocity[1] + dampingSin*velocity[2]) - (stiffness - 8/3*modal*cubic*position[1]^2)*position[1]
      + 2*modal*((splitCos - wave*pumping[1])*position[1] + (splitSin - wave*pumping[3])*position[2]) + drive[1],
    -coupling*velocity[1] - 2*(dampingY*velocity[2] + dampingSin*velocity[1]) - (stiffness - 8/3*modal*cubic*position[2]^2)*position[2]
      + 2*modal*((splitSin - wave*pumping[3])*position[1] - (splitCos + wave*pumping[2])*position[2]) + drive[2]};
  annotation (Documentation(info="<html>
<p>With kappa = n k (0.554) and K the stiffness,</p>
<pre>x'' - 2 kappa W y' - kappa W' y + (2/tau) x' + D (x' ct + y' st) + w^2 x - w dw (x cw + y sw) + gamma (x^2 + y^2) x - gamma_e x^3 = fx
y'' + 2 kappa W x' + kappa W' x + (2/tau) y' + D (x' st - y' ct) + w^2 y - w dw (x sw - y cw) + gamma (x^2 + y^2) y - gamma_e y^3 = fy</pre>
<p>written with the momenta x' - kappa W y and y' + kappa W x, so that no derivative of the rate is needed. The
centrifugal term, an isotropic shift of the frequency, is left out. Forces that carry a growth U of the envelope have
the amplitude 2 w U, in phase with the velocity. Parametric drive of growth R modulates the squared frequency by 4 w R sin 2P. The reference oscillator is integrated beside the modes: both see the same
step error, which leaves the demodulated phase.</p>
</html>"));
end Oscillator;
