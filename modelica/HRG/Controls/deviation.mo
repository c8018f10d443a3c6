within HRG.Controls;
function deviation "Detected orbit against the true one"
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  output Real result[6] "{detected amplitude, quadrature, phase less the true one, cosine and sine of the detected modal angle, detected modal angle less the true one}";
protected
  Real c[2] "In phase with the reference, along the true antinode and across";
  Real s[2] "In quadrature with it, likewise";
  Real along "Energy along the true antinode";
  Real across "Energy across";
  Real r "(a^2 - q^2) times the cosine of twice the angle between";
  Real t "(a^2 - q^2) times its sine";
  Real x "Tangent of twice the angle between";
  Real y "Its square; 1 beyond a quarter of a circle";
  Real l "a^2 - q^2";
  Real u "l + r";
  Real scale "Inverse length of {u, t}";
  Real cosine "Of the angle between the detected and the true antinode";
  Real sine "Of the angle between";
  Real antinode[2] "Reading on the detected antinode";
  Real tangent "Of the difference of the phases";
algorithm
  c[1] := axes[1]*reading[1] + axes[2]*reading[3];
  s[1] := axes[1]*reading[2] + axes[2]*reading[4];
  c[2] := axes[1]*reading[3] - axes[2]*reading[1];
  s[2] := axes[1]*reading[4] - axes[2]*reading[2];
  along := c[1]*c[1] + s[1]*s[1];
  across := c[2]*c[2] + s[2]*s[2];
  r := along - across;
  t := 2*(c[1]*c[2] + s[1]*s[2]);
  x := t/r;
  y := if r > 0 then x*x else 1;
  l := if y < 1e-4 then r*((1 + y/2) + y*y*(-1/8 + y/16)) else sqrt(r*r + t*t);
  u := l + r;
  scale := if y < 1e-4 then 0 else 1/sqrt(u*u + t*t);
  cosine := if y < 1e-4 then (1 - y/8) + y*y*(11/128 - 69/1024*y) else u*scale;
  sine := if y < 1e-4 then x*((1/2 - 3/16*y) + y*y*(31/256 - 187/2048*y)) else t*scale;
  result[1] := sqrt((along + across + l)/2);
  result[2] := (c[1]*s[2] - c[2]*s[1])/result[1];
  antinode[1] := c[1]*cosine + c[2]*sine;
  antinode[2] := s[1]*cosine + s[2]*sine;
  tangent := -(axes[3]*antinode[2] + axes[4]*antinode[1])/(axes[3]*antinode[1] - axes[4]*antinode[2]);
  result[3] := tangent*(1 - tangent*tangent*(1/3 - tangent*tangent/5));
  result[4] := axes[1]*cosine - axes[2]*sine;
  result[5] := axes[2]*cosine + axes[1]*sine;
  result[6] := sine*(1 + sine*sine*(1/6 + 3/40*sine*sine));
  annotation (Documentation(info="<html>
<p>As <code>orbit</code>, in the frame of the true orbit, where the angles between are small and no transcendental function is
needed. Both differences are series to the fifth order. With x the tangent of twice the angle between, that of half the arc tangent is, up to 0.01,</p>
<pre>cosine = 1 - x^2/8 + 11 x^4/128 - 69 x^6/1024,  sine = x/2 - 3 x^3/16 + 31 x^5/256 - 187 x^7/2048</pre>
<p>right to the last bit but one and quicker than roots, which are taken beyond.</p>
</html>"));
end deviation;
