within HRG.Resonators;
model Envelope "Slowly varying envelope of the two n = 2 modes"
  parameter Units.AngularFrequency duffing(min = -100, max = 100) = 0
    "Frequency shift at unit amplitude by cubic stiffness, typically 1e-6 of the frequency";
  parameter Units.Displacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at time 0";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  input Units.Rate dampingX "Damping of x";
  input Units.Rate dampingY "Damping of y";
  input Units.Rate dampingSin "Damping between x and y";
  input Units.AngularFrequency shift "Mean frequency above the nominal one";
  input Units.AngularFrequency splitCos "Stiffness anisotropy, diagonal";
  input Units.AngularFrequency splitSin "Stiffness anisotropy, off diagonal";
  input Units.AngularRate coupling "Bryan coupling of the modes, n k Omega with n = 2";
  input Units.AngularFrequency reference "Frequency of the rotating frame above the nominal one";
  input Units.Force force[4] "Forces on the envelope, {cos x, sin x, cos y, sin y}";
  output Units.Displacement displacement[4] "In-phase and quadrature displacement {cx, sx, cy, sy}";
protected
  Units.Displacement cx(start = startAmplitude*cos(2*startAngle), fixed = true) "Component of x in phase with the reference";
  Units.Displacement sx(start = 0, fixed = true) "Component of x in quadrature with the reference";
  Units.Displacement cy(start = startAmplitude*sin(2*startAngle), fixed = true) "Component of y in phase with the reference";
  Units.Displacement sy(start = 0, fixed = true) "Component of y in quadrature with the reference";
  Units.AngularFrequency detuningX "Of the rotating frame above x";
  Units.AngularFrequency detuningY "Of the rotating frame above y";
  Units.AngularFrequency swing "Duffing shift by both modes' squared amplitude";
  Units.AngularFrequency ellipse "Duffing coupling by the orbit's area";
equation
  detuningX = reference - shift + splitCos;
  detuningY = reference - shift - splitCos;
  swing = duffing*(cx*cx + sx*sx + cy*cy + sy*sy);
  ellipse = 2/3*duffing*(cx*sy - cy*sx);
  der(cx) = -dampingX*cx - dampingSin*cy - (detuningX - swing)*sx - splitSin*sy + (coupling + ellipse)*cy + force[1];
  der(sx) = -dampingX*sx - dampingSin*sy + (detuningX - swing)*cx + splitSin*cy + (coupling + ellipse)*sy + force[2];
  der(cy) = -dampingY*cy - dampingSin*cx - (detuningY - swing)*sy - splitSin*sx - (coupling + ellipse)*cx + force[3];
  der(sy) = -dampingY*sy - dampingSin*sx + (detuningY - swing)*cy + splitSin*cx - (coupling + ellipse)*sx + force[4];
  displacement = {cx, sx, cy, sy};
  annotation (Documentation(info="<html>
<p>With x = cx cos P + sx sin P, y alike, P the phase of the rotating frame, X = cx - i sx, Z = [X; Y]:</p>
<pre>Z' = -i nu Z - Z/tau - (D/2) [[ct, st], [st, -ct]] Z - (i dw/2) [[cw, sw], [sw, -cw]] Z + 2 k Omega [[0, 1], [-1, 0]] Z + U</pre>
<p>ct = cos 4 theta_tau, cw = cos 4 theta_w; nu is the frame's frequency above the mean modal one, U the force as a
growth of the envelope, U = -(i/2w) F. The equation is the average over a carrier period of the two coupled
oscillators (D. D. Lynch's form); without the Duffing term it is linear, so that a step of a control period loses nothing.</p>
<p>A cubic stiffness, x'' + w^2 x + gamma (x^2 + y^2) x, averages to a frequency shift delta = 3 gamma/8w at unit
amplitude, X' = i delta [(|X|^2 + |Y|^2) X] + (2/3) delta (cx sy - cy sx) Y, and Y alike with the other sign: an orbit
of quadrature q precesses as if the case turned at delta a q/(3 k).</p>
</html>"));
end Envelope;
