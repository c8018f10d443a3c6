within HRG.Resonators;
model AnisotropicEnvelope "Slowly varying envelope of the two n = 2 modes, damping and stiffness anisotropic"
  parameter Units.Time decayTime(min = 1e-3) = 450 "Mean amplitude decay time tau";
  parameter Units.Rate dampingAnisotropy(min = 0) = 0 "D = 1/tau1 - 1/tau2 between the axes of maximum and minimum damping";
  parameter Units.Angle dampingAxis = 0 "Pattern angle of maximum damping";
  parameter Units.AngularFrequency frequencySplit(min = 0) = 0 "Difference of the two modes' circular frequencies";
  parameter Units.Angle stiffnessAxis = 0 "Pattern angle of the mode of lower frequency";
  parameter Units.Ratio bryanFactor(min = 0.01, max = 1) = 0.277 "Precession of the pattern over rotation of the case";
  parameter Units.Displacement startAmplitude(min = 0) = 1 "Antinode amplitude at time 0";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  input Units.AngularRate angularRate "Inertial rate about the input axis";
  input Units.AngularFrequency detuning "Frequency of the rotating frame above the mean modal frequency";
  input Units.Force force[4] "Forces on the envelope, {cos x, sin x, cos y, sin y}";
  output Units.Displacement envelope[4] "In-phase and quadrature displacement {cx, sx, cy, sy}";
protected
  final parameter Units.Rate meanDamping = 1/decayTime "Damping of the mean";
  final parameter Units.Rate dampingCos = dampingAnisotropy/2*cos(4*dampingAxis) "Anisotropic damping, diagonal";
  final parameter Units.Rate dampingSin = dampingAnisotropy/2*sin(4*dampingAxis) "Anisotropic damping, off diagonal";
  final parameter Units.Rate dampingX = meanDamping + dampingCos "Damping of x";
  final parameter Units.Rate dampingY = meanDamping - dampingCos "Damping of y";
  final parameter Units.AngularFrequency splitCos = frequencySplit/2*cos(4*stiffnessAxis) "Anisotropic stiffness, diagonal";
  final parameter Units.AngularFrequency splitSin = frequencySplit/2*sin(4*stiffnessAxis) "Anisotropic stiffness, off diagonal";
  Units.Displacement cx(start = startAmplitude*cos(2*startAngle), fixed = true) "Component of x in phase with the reference";
  Units.Displacement sx(start = 0, fixed = true) "Component of x in quadrature with the reference";
  Units.Displacement cy(start = startAmplitude*sin(2*startAngle), fixed = true) "Component of y in phase with the reference";
  Units.Displacement sy(start = 0, fixed = true) "Component of y in quadrature with the reference";
  Units.AngularRate coupling "Bryan coupling of the modes, n k Omega with n = 2";
  Units.AngularFrequency detuningX "Detuning of x";
  Units.AngularFrequency detuningY "Detuning of y";
equation
  coupling = 2*bryanFactor*angularRate;
  detuningX = detuning + splitCos;
  detuningY = detuning - splitCos;
  der(cx) = -dampingX*cx - dampingSin*cy - detuningX*sx - splitSin*sy + coupling*cy + force[1];
  der(sx) = -dampingX*sx - dampingSin*sy + detuningX*cx + splitSin*cy + coupling*sy + force[2];
  der(cy) = -dampingY*cy - dampingSin*cx - detuningY*sy - splitSin*sx - coupling*cx + force[3];
  der(sy) = -dampingY*sy - dampingSin*sx + detuningY*cy + splitSin*cx - coupling*sx + force[4];
  envelope = {cx, sx, cy, sy};
  annotation (Documentation(info="<html>
<p>With x = cx cos P + sx sin P, y alike, P the phase of the rotating frame, X = cx - i sx, Z = [X; Y]:</p>
<pre>Z' = -i nu Z - Z/tau - (D/2) [[ct, st], [st, -ct]] Z - (i dw/2) [[cw, sw], [sw, -cw]] Z + 2 k Omega [[0, 1], [-1, 0]] Z + U</pre>
<p>ct = cos 4 theta_tau, cw = cos 4 theta_w; nu is the detuning and U the force as a growth of the envelope,
U = -(i/2w) F. The equation is the average over a carrier period of the two coupled oscillators
(D. D. Lynch's form); it is linear, so that a step of a control period loses nothing.</p>
</html>"));
end AnisotropicEnvelope;
