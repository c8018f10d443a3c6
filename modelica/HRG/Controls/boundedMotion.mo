within HRG.Controls;
function boundedMotion "Motion of the orbit under forces that the drives' authority may clip"
  input Units.RelativeForce forces[3] "Wanted on the antinode, on the node in quadrature, on the node that rotates";
  input Real h[4] "Free rates on the true axes: {antinode real, imaginary, node real, imaginary}";
  input Units.RelativeDisplacement amplitude "True antinode amplitude a";
  input Units.RelativeDisplacement quadrature "True quadrature q";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.DimensionlessRatio aim[2] "Cosine and sine of the modal angle that forces are resolved with";
  input Units.DimensionlessRatio gain[4] "Drives' force over command, {x by x, x by y, y by x, y by y}";
  input Units.RelativeForce authority "A channel clips at this force";
  output Real result[8] "{rates of modal angle, amplitude and quadrature, of the phase and the reference together; forces given, as wanted; 1 where a channel clips}";
protected
  Units.RelativeForce channels[4] "Command without a limit {cos x, sin x, cos y, sin y}";
  Units.RelativeForce bounded[4] "Command within the drives' authority {cos x, sin x, cos y, sin y}";
  Units.RelativeForce turned[4] "On the shell";
  Units.RelativeForce force[4] "On the shell, less the phase";
  Real total[4] "Rates on the true axes";
  Real spread "Inverse of a^2 - q^2";
algorithm
  channels[1] := forces[1]*aim[1] - forces[3]*aim[2];
  channels[2] := -forces[2]*aim[2];
  channels[3] := forces[1]*aim[2] + forces[3]*aim[1];
  channels[4] := forces[2]*aim[1];
  bounded[1] := Electrodes.digitised(channels[1], 0, authority);
  bounded[2] := Electrodes.digitised(channels[2], 0, authority);
  bounded[3] := Electrodes.digitised(channels[3], 0, authority);
  bounded[4] := Electrodes.digitised(channels[4], 0, authority);
  turned[1] := gain[1]*bounded[1] + gain[2]*bounded[3];
  turned[2] := gain[1]*bounded[2] + gain[2]*bounded[4];
  turned[3] := gain[3]*bounded[1] + gain[4]*bounded[3];
  turned[4] := gain[3]*bounded[2] + gain[4]*bounded[4];
  force[1] := axes[3]*turned[1] - axes[4]*turned[2];
  force[2] := axes[3]*turned[2] + axes[4]*turned[1];
  force[3] := axes[3]*turned[3] - axes[4]*turned[4];
  force[4] := axes[3]*turned[4] + axes[4]*turned[3];
  total[1] := h[1] + axes[1]*force[1] + axes[2]*force[3];
  total[2] := h[2] - axes[1]*force[2] - axes[2]*force[4];
  total[3] := h[3] + axes[1]*force[3] - axes[2]*force[1];
  total[4] := h[4] - axes[1]*force[4] + axes[2]*force[2];
  spread := 1/(amplitude*amplitude - quadrature*quadrature);
  result[1] := (amplitude*total[3] - quadrature*total[2])*spread;
  result[2] := total[1];
  result[3] := -total[4];
  result[4] := (amplitude*total[2] - quadrature*total[3])*spread;
  result[5] := bounded[1]*aim[1] + bounded[3]*aim[2];
  result[6] := bounded[4]*aim[1] - bounded[2]*aim[2];
  result[7] := bounded[3]*aim[1] - bounded[1]*aim[2];
  result[8] := if abs(channels[1] - bounded[1]) + abs(channels[2] - bounded[2]) + abs(channels[3] - bounded[3])
    + abs(channels[4] - bounded[4]) > 0 then 1 else 0;
  annotation (Documentation(info="<html>
<p>As <code>precession</code>, with h the rates of the envelope on the true axes, forces included, antinode (a) and node (n):</p>
<pre>a' = Re h_a    q' = -Im h_n    alpha' = (a Re h_n - q Im h_a)/(a^2 - q^2)    psi = (a Im h_a - q Re h_n)/(a^2 - q^2)</pre>
<p>alpha is the modal angle, psi the rate of the phase and the reference together. Elements 5 to 7 are the clipped forces. No loop is taken as closed: a clipped force
leaves what it can't hold to the motion.</p>
</html>"));
end boundedMotion;
