within HRG.Controls;
function orbit "Orbit of the vibration, from the demodulated displacement"
  input Units.RelativeDisplacement reading[4] "Demodulated displacement {cx, sx, cy, sy}";
  input Units.Angle previous "Modal angle to which the result is the nearest, of those that differ by pi";
  output Real result[6] "{modal angle, its cosine and sine, antinode amplitude, quadrature amplitude, phase}";
protected
  Real cx2 "cx squared";
  Real sx2 "sx squared";
  Real cy2 "cy squared";
  Real sy2 "sy squared";
  Real energy "E = a^2 + q^2";
  Real r "R = (a^2 - q^2) cos 2 alpha";
  Real s "S = (a^2 - q^2) sin 2 alpha";
  Units.Angle principal "Modal angle within (-pi/2, pi/2]";
  Real length "a^2 - q^2";
  Real twiceCosine "cos 2 alpha; 1 of a circle, whose angle is 0";
  Real twiceSine "sin 2 alpha";
  Real major "Larger of the principal angle's cosine and sine, without sign";
  Real minor "The smaller, with the sign of the sine of twice the angle";
  Real halfTurns "By which the angle is beyond the principal one";
  Real turned "1, or -1 for an odd number of half turns";
  Units.RelativeDisplacement amplitude "Antinode amplitude a";
  Real cosine "Of the modal angle";
  Real sine "Of the modal angle";
algorithm
  cx2 := reading[1]*reading[1];
  sx2 := reading[2]*reading[2];
  cy2 := reading[3]*reading[3];
  sy2 := reading[4]*reading[4];
  energy := cx2 + sx2 + cy2 + sy2;
  r := cx2 + sx2 - cy2 - sy2;
  s := 2*(reading[1]*reading[3] + reading[2]*reading[4]);
  length := sqrt(r*r + s*s);
  twiceCosine := if length > 0 then r/length else 1;
  twiceSine := if length > 0 then s/length else 0;
  major := sqrt((1 + abs(twiceCosine))/2);
  minor := twiceSine/(2*major);
  principal := atan2(s, r)/2;
  halfTurns := floor((previous - principal)/Constants.pi + 0.5);
  turned := 1 - 2*(halfTurns - 2*floor(halfTurns/2));
  cosine := turned*(if r >= 0 then major else abs(minor));
  sine := turned*(if r >= 0 then minor elseif principal < 0 then -major else major);
  amplitude := sqrt((energy + length)/2);
  result[1] := principal + Constants.pi*halfTurns;
  result[2] := cosine;
  result[3] := sine;
  result[4] := amplitude;
  result[5] := (reading[1]*reading[4] - reading[3]*reading[2])/amplitude;
  result[6] := atan2(-(reading[2]*cosine + reading[4]*sine), reading[1]*cosine + reading[3]*sine);
  annotation (Documentation(info="<html>
<p>E = cx^2 + sx^2 + cy^2 + sy^2, R = cx^2 + sx^2 - cy^2 - sy^2, S = 2 (cx cy + sx sy),
Q = 2 (cx sy - cy sx) = 2 a q; the modal angle is atan2(S, R)/2, a^2 = (E + sqrt(R^2 + S^2))/2 (D. D. Lynch). Its
cosine and sine follow by the formulas of half the angle.</p>
</html>"));
end orbit;
