within HRG.Resonators;
function envelopeRates "Rates of the free envelope in a frame that rotates with the reference"
  input Units.RelativeDisplacement displacement[4] "{cx, sx, cy, sy}";
  input Units.DampingCoefficient inPhase[3] "Damping of x, of y and between them, of what is in phase with the reference";
  input Units.DampingCoefficient inQuadrature[3] "The same, of what is in quadrature with it";
  input Units.AngularFrequency detuning "Of the frame above the mean modal frequency";
  input Units.AngularFrequency splitCos "Stiffness anisotropy, diagonal";
  input Units.AngularFrequency splitSin "Stiffness anisotropy, off diagonal";
  input Units.AngularVelocity coupling "Bryan coupling of the modes, n k Omega with n = 2";
  input Units.AngularFrequency duffing "Frequency shift at unit amplitude by cubic stiffness";
  input Units.AngularFrequency cubic "Softening of x and of y at unit amplitude of their own";
  output Real rates[4] "Derivatives of the displacement";
protected
  Real cx "Component of x in phase with the reference";
  Real sx "Component of x in quadrature with the reference";
  Real cy "Component of y in phase with the reference";
  Real sy "Component of y in quadrature with the reference";
  Real detuningX "Of the frame above x, its shift by the amplitude included";
  Real detuningY "Of the frame above y, its shift by the amplitude included";
  Real squareX "Squared amplitude of x";
  Real squareY "Squared amplitude of y";
  Real swing "Duffing shift by both modes' squared amplitude";
  Real turn "Coupling, that of the orbit's area included";
algorithm
  cx := displacement[1];
  sx := displacement[2];
  cy := displacement[3];
  sy := displacement[4];
  squareX := cx*cx + sx*sx;
  squareY := cy*cy + sy*sy;
  swing := duffing*(squareX + squareY);
  turn := coupling + 2/3*duffing*(cx*sy - cy*sx);
  detuningX := detuning + splitCos - (swing - cubic*squareX);
  detuningY := detuning - splitCos - (swing - cubic*squareY);
  rates[1] := -inPhase[1]*cx - inPhase[3]*cy - detuningX*sx - splitSin*sy + turn*cy;
  rates[2] := -inQuadrature[1]*sx - inQuadrature[3]*sy + detuningX*cx + splitSin*cy + turn*sy;
  rates[3] := -inPhase[2]*cy - inPhase[3]*cx - detuningY*sy - splitSin*sx - turn*cx;
  rates[4] := -inQuadrature[2]*sy - inQuadrature[3]*sx + detuningY*cy + splitSin*cx - turn*sx;
  annotation (Documentation(info="<html>
<p>With x = cx cos P + sx sin P, y alike, P the phase of the rotating frame, X = cx - i sx, Z = [X; Y]:</p>
<pre>Z' = -i nu Z - Z/tau - (D/2) [[ct, st], [st, -ct]] Z - (i dw/2) [[cw, sw], [sw, -cw]] Z + 2 k Omega [[0, 1], [-1, 0]] Z</pre>
<p>ct = cos 4 theta_tau, cw = cos 4 theta_w; nu is the frame's frequency above the mean modal one.
The equation is the average over a carrier period of the two coupled oscillators (D. D. Lynch's form).</p>
<p>A cubic stiffness, x'' + w^2 x + gamma (x^2 + y^2) x, averages to a frequency shift delta = 3 gamma/8w at unit
amplitude, X' = i delta [(|X|^2 + |Y|^2) X] + (2/3) delta (cx sy - cy sx) Y, and Y alike with the other sign: an orbit
of quadrature q precesses as if the case turned at delta a q/(3 k). A cubic softening of each mode by itself, - gamma x^3 and - gamma y^3, is
X' = -i delta |X|^2 X, and Y' alike.</p>
</html>"));
end envelopeRates;
