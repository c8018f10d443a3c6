within HRG.Resonators;
block MassDefects "Harmonics 1 to 3 of the rim's mass: support loss, and forces by vibration of the case"
  parameter Units.DimensionlessRatio first(min = 0, max = 0.1) = 0 "First harmonic of the rim's mass over the modal mass, typically 1e-4 to 5e-3 (estimate)";
  parameter Units.Angle firstAxis(min = -1000, max = 1000) = 0 "Azimuth of its heaviest place";
  parameter Units.DimensionlessRatio second(min = 0, max = 0.1) = 0 "Second harmonic, likewise, typically 1e-4 to 2e-3 (estimate)";
  parameter Units.Angle secondAxis(min = -1000, max = 1000) = 0 "Azimuth of a heaviest place of it";
  parameter Units.DimensionlessRatio third(min = 0, max = 0.1) = 0 "Third harmonic, likewise, typically 1e-4 to 2e-3 (estimate)";
  parameter Units.Angle thirdAxis(min = -1000, max = 1000) = 0 "Azimuth of a heaviest place of it";
  parameter Units.DampingCoefficient lateralLoss(min = 0, max = 1e4) = 0
    "Loss in the support by a sway of the shell, for harmonics of 1, typically 1 to 100: an anisotropy of 1e-7 to 1e-5 by harmonics of 1e-3 and 1e-4 (estimate)";
  parameter Units.DampingCoefficient axialLoss(min = 0, max = 1e4) = 0 "Loss in the support by a heave of the shell, likewise, typically 1 to 100 (estimate)";
  parameter Real vibrationForce[3](each unit = "s/m", each min = -1e3, each max = 1e3) = {0, 0, 0}
    "Force over in-phase vibration {x, y, z} for harmonics of 1, 1/(2 w a) times the vibration's direction, typically 3 to 20 at an amplitude of 1 um";
  final parameter Units.DampingCoefficient loss = lateralLoss*((3*first/4)^2 + (third/4)^2) + axialLoss*second^2/8 "Mean damping by the support";
  final parameter Units.DampingCoefficient lossCos = 3/8*lateralLoss*first*third*cos(firstAxis + 3*thirdAxis)
    + axialLoss*second^2/8*cos(4*secondAxis) "Anisotropic damping, diagonal";
  final parameter Units.DampingCoefficient lossSin = 3/8*lateralLoss*first*third*sin(firstAxis + 3*thirdAxis)
    + axialLoss*second^2/8*sin(4*secondAxis) "Anisotropic damping, off diagonal";
  final parameter Real forceX(unit = "s/m") = -(swayCos + loopCos)*vibrationForce[1] - (loopSin - swaySin)*vibrationForce[2]
    - heaveCos*vibrationForce[3] "Force on x over vibration";
  final parameter Real forceY(unit = "s/m") = -(swaySin + loopSin)*vibrationForce[1] - (swayCos - loopCos)*vibrationForce[2]
    - heaveSin*vibrationForce[3] "Force on y over vibration";
protected
  final parameter Units.DimensionlessRatio swayCos = 3/4*first*cos(firstAxis) "Share of the first harmonic in a sway";
  final parameter Units.DimensionlessRatio swaySin = 3/4*first*sin(firstAxis) "Share of the first harmonic in a sway";
  final parameter Units.DimensionlessRatio loopCos = third/4*cos(3*thirdAxis) "Share of the third harmonic in a sway";
  final parameter Units.DimensionlessRatio loopSin = third/4*sin(3*thirdAxis) "Share of the third harmonic in a sway";
  final parameter Units.DimensionlessRatio heaveCos = second/2*cos(2*secondAxis) "Share of the second harmonic in a heave";
  final parameter Units.DimensionlessRatio heaveSin = second/2*sin(2*secondAxis) "Share of the second harmonic in a heave";
  annotation (Documentation(info="<html>
<p>At the rim a mode moves outwards by w, along the rim by w/2 a quarter of a lobe later, and upwards by w/2 (Rayleigh's inextensional n = 2 mode). With a
mass of 1 + m_n cos n (phi - phi_n) there, {x, y} shake the shell sideways and up and down by</p>
<pre>{X, Y} = [[3/4 m1 c1 + m3/4 c3, 3/4 m1 s1 + m3/4 s3], [m3/4 s3 - 3/4 m1 s1, 3/4 m1 c1 - m3/4 c3]] {x, y},  Z = m2/2 (c2 x + s2 y)</pre>
<p>c_n, s_n of n phi_n. What the support takes of it is damping, lateralLoss (X^2 + Y^2) + axialLoss Z^2: an anisotropy of</p>
<pre>(3/4) lateralLoss m1 m3 about (phi_1 + 3 phi_3)/4,  (1/4) axialLoss m2^2 about phi_2</pre>
<p>and the mean lateralLoss (9 m1^2 + m3^2)/16 + axialLoss m2^2/8. A first harmonic alone costs decay time and makes no bias. The same matrix turns a vibration of
the case at the modal frequency into forces on the modes, as <code>imbalanceX</code> and <code>imbalanceY</code>. Mechanism 35.</p>
</html>"));
end MassDefects;
