within HRG.UsersGuide;
class Conventions "Symbols, angles, signs and units"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>SI and radians throughout. Displacements are relative to the nominal antinode amplitude; forces are the growth that
they give to the envelope, in 1/s.</p>
<table border=\"1\">
<tr><th>symbol</th><th>meaning</th></tr>
<tr><td>theta</td><td>pattern angle: physical azimuth of the antinode, period 90 degrees up to the sign of the wave; the
modal angle, in the plane of the two displacements, is 2 theta</td></tr>
<tr><td>k</td><td>Bryan factor: d theta/dt = -k Omega</td></tr>
<tr><td>tau</td><td>mean amplitude decay time</td></tr>
<tr><td>D, theta_tau</td><td>damping anisotropy 1/tau_1 - 1/tau_2 &gt; 0, and its axis of maximum damping</td></tr>
<tr><td>dw, theta_w</td><td>frequency split, and the axis of the mode of lower frequency</td></tr>
<tr><td>a, q</td><td>amplitudes of antinode and quadrature</td></tr>
<tr><td>B</td><td>output bias: <code>gyroAngle</code> is positive with the rotation of the case, the pattern's rate is -k times it</td></tr>
</table>
</html>"));
end Conventions;
