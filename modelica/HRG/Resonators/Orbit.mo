within HRG.Resonators;
model Orbit "Motion of the two n = 2 modes in the elements of their orbit"
  parameter Units.RelativeDisplacement startAmplitude(min = 1e-6, max = 10) = 1 "Antinode amplitude at time 0";
  parameter Units.Angle startAngle = 0 "Pattern angle at time 0";
  input Real rates[4] "Derivatives of modal angle, amplitude, quadrature and phase";
  output Units.Angle modalAngle(start = 2*startAngle, fixed = true) "Twice the pattern angle";
  output Units.RelativeDisplacement amplitude(start = startAmplitude, fixed = true) "Antinode amplitude a";
  output Units.RelativeDisplacement quadrature(start = 0, fixed = true) "Quadrature amplitude q";
  output Units.Angle phase(start = 0, fixed = true) "Phase of the antinode against the reference";
  output Units.DimensionlessRatio axes[4] "{cosine and sine of the modal angle, cosine and sine of the phase}";
  output Units.RelativeDisplacement displacement[4] "{cx, sx, cy, sy}";
equation
  der(modalAngle) = rates[1];
  der(amplitude) = rates[2];
  der(quadrature) = rates[3];
  der(phase) = rates[4];
  axes = {cos(modalAngle), sin(modalAngle), cos(phase), sin(phase)};
  displacement = {
    amplitude*axes[1]*axes[3] - quadrature*axes[2]*axes[4],
    -amplitude*axes[1]*axes[4] - quadrature*axes[2]*axes[3],
    amplitude*axes[2]*axes[3] + quadrature*axes[1]*axes[4],
    -amplitude*axes[2]*axes[4] + quadrature*axes[1]*axes[3]};
  annotation (Documentation(info="<html>
<p>Z = exp(i phi) (a [cos alpha; sin alpha] - i q [-sin alpha; cos alpha]), alpha the modal angle (D. D. Lynch). A
constant rotation is a straight line in these elements, however long the step.</p>
</html>"));
end Orbit;
