within HRG.Controls;
function deviation "Detected orbit against the true one"
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  output Real result[6] "{detected amplitude, quadrature, phase less the true one, cosine and sine of the detected modal angle, detected modal angle less the true one}";
protected
  Real c[2] "In phase with the true antinode, along it and across";
  Real s[2] "In quadrature, along it and across";
  Real turned[4] "Reading less the true phase";
  Real energy "a^2 + q^2";
  Real r "(a^2 - q^2) times the cosine of twice the angle between";
  Real t "(a^2 - q^2) times its sine";
  Real l "a^2 - q^2";
  Real cosine "Of the angle between the detected and the true antinode";
  Real sine "Of the angle between";
  Real tangent "Of the difference of the phases";
algorithm
  turned[1] := axes[3]*reading[1] - axes[4]*reading[2];
  turned[2] := axes[3]*reading[2] + axes[4]*reading[1];
  turned[3] := axes[3]*reading[3] - axes[4]*reading[4];
  turned[4] := axes[3]*reading[4] + axes[4]*reading[3];
  c[1] := axes[1]*turned[1] + axes[2]*turned[3];
  s[1] := axes[1]*turned[2] + axes[2]*turned[4];
  c[2] := axes[1]*turned[3] - axes[2]*turned[1];
  s[2] := axes[1]*turned[4] - axes[2]*turned[2];
  energy := c[1]*c[1] + s[1]*s[1] + c[2]*c[2] + s[2]*s[2];
  r := c[1]*c[1] + s[1]*s[1] - c[2]*c[2] - s[2]*s[2];
  t := 2*(c[1]*c[2] + s[1]*s[2]);
  l := sqrt(r*r + t*t);
  cosine := sqrt((l + r)/(2*l));
  sine := t/(2*l*cosine);
  result[1] := sqrt((energy + l)/2);
  result[2] := (c[1]*s[2] - c[2]*s[1])/result[1];
  tangent := -(s[1]*cosine + s[2]*sine)/(c[1]*cosine + c[2]*sine);
  result[3] := tangent*(1 - tangent*tangent*(1/3 - tangent*tangent/5));
  result[4] := axes[1]*cosine - axes[2]*sine;
  result[5] := axes[2]*cosine + axes[1]*sine;
  result[6] := sine*(1 + sine*sine*(1/6 + 3/40*sine*sine));
  annotation (Documentation(info="<html>
<p>As <code>orbit</code>, in the frame of the true orbit, where the angles between are small and no transcendental function is
needed. Both differences are series to the fifth order.</p>
</html>"));
end deviation;
