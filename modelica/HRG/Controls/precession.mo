within HRG.Controls;
function precession "Motion of the orbit under loops that are at rest, and the forces that keep them there"
  input Real free[4] "Rates of the displacement without drive, {cx, sx, cy, sy}";
  input Units.RelativeDisplacement amplitude "True antinode amplitude a";
  input Units.RelativeDisplacement quadrature "True quadrature q";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.RelativeDisplacement detected "Detected amplitude, which forces are scaled with";
  input Units.DimensionlessRatio aim[2] "Cosine and sine of the modal angle that forces are resolved with";
  input Units.DimensionlessRatio gain[4] "Drives' force over command, {x by x, x by y, y by x, y by y}";
  input Units.DimensionlessRatio pumpGain[3] "Growth by parametric drive over command, of x, of y and between them";
  input Units.DimensionlessRatio parametricShare "Share of the force on the antinode that parametric drive gives";
  input Units.RelativeForce authority "A channel clips at this force; 0: never";
  input Units.DimensionlessRatio driveOn "1 with the drive on, 0 off";
  input Real wanted[4] "Rates that loops ask for: of modal angle, amplitude, quadrature and phase";
  input Units.AngularVelocity patternRate "Commanded rotation of the pattern, in the whole-angle mode";
  input Real rebalance "1: the rate of the modal angle is what loops ask for; 0: the pattern is free";
  output Real result[10] "{rates of modal angle, amplitude, quadrature and phase; forces given on the antinode, on the node in quadrature, on the node; reference; force on the node that the authority took away; 1 while the drive holds amplitude and quadrature, 0 with it off or a channel clipped}";
protected
  Real turned[4] "Free rates less the phase";
  Real h[4] "Free rates on the true axes: {antinode real, imaginary, node real, imaginary}";
  Real pump[4] "Share of parametric drive in a unit force on the detected antinode, as of pumpRates()";
  Real along[2] "Unit force on the detected antinode, on the true antinode and node";
  Real lag[2] "The same a quarter of a period behind";
  Real across[2] "Unit force on the detected node, likewise";
  Real inverse "Of the determinant of the loops' equations";
  Real base[2] "Forces on antinode and, in quadrature, on the node, that hold the orbit without rotation, times the determinant";
  Real slope[2] "Their change per force that rotates, likewise";
  Real reach[4] "Antinode's imaginary rate by these forces, and node's real one";
  Real spread "Inverse of a^2 - q^2";
  Real still[2] "Antinode's imaginary and node's real rate without a force that rotates";
  Real push[2] "Their change per force that rotates";
  Real drift "Rate of the modal angle without a force that rotates";
  Real response "Rate of the modal angle per force that rotates";
  Real on "1 with the drive on, 0 off";
  Real antinode "Force on the antinode";
  Real node "Force on the node that rotates";
  Real square "Force on the node in quadrature";
  Real swing "Rate of the phase and the reference together, without a force that rotates";
  Real reaction "The same per force that rotates";
  Real forces[3] "Of the electrodes, all three";
  Real motion[8] "As of boundedMotion()";
algorithm
  turned[1] := axes[3]*free[1] - axes[4]*free[2];
  turned[2] := axes[3]*free[2] + axes[4]*free[1];
  turned[3] := axes[3]*free[3] - axes[4]*free[4];
  turned[4] := axes[3]*free[4] + axes[4]*free[3];
  h[1] := axes[1]*turned[1] + axes[2]*turned[3];
  h[2] := -axes[1]*turned[2] - axes[2]*turned[4];
  h[3] := axes[1]*turned[3] - axes[2]*turned[1];
  h[4] := -axes[1]*turned[4] + axes[2]*turned[2];
  pump := if parametricShare > 0 then pumpRates(amplitude, quadrature, axes, pumpGain, parametricShare/detected) else {0, 0, 0, 0};
  along[1] := (1 - parametricShare)*(axes[1]*(gain[1]*aim[1] + gain[2]*aim[2]) + axes[2]*(gain[3]*aim[1] + gain[4]*aim[2])) + pump[1];
  along[2] := (1 - parametricShare)*(axes[1]*(gain[3]*aim[1] + gain[4]*aim[2]) - axes[2]*(gain[1]*aim[1] + gain[2]*aim[2])) + pump[3];
  lag[1] := pump[2];
  lag[2] := pump[4];
  across[1] := axes[1]*(gain[2]*aim[1] - gain[1]*aim[2]) + axes[2]*(gain[4]*aim[1] - gain[3]*aim[2]);
  across[2] := axes[1]*(gain[4]*aim[1] - gain[3]*aim[2]) - axes[2]*(gain[2]*aim[1] - gain[1]*aim[2]);
  spread := 1/(amplitude*amplitude - quadrature*quadrature);
  inverse := 1/(axes[3]*axes[3]*along[1]*across[2] + axes[4]*axes[4]*across[1]*along[2]
    - axes[3]*axes[4]*(lag[1]*across[2] - lag[2]*across[1]));
  base[1] := axes[3]*across[2]*(wanted[2] - h[1]) + axes[4]*across[1]*(wanted[3] + h[4]);
  base[2] := (axes[3]*along[1] - axes[4]*lag[1])*(wanted[3] + h[4]) - (axes[4]*along[2] + axes[3]*lag[2])*(wanted[2] - h[1]);
  slope[1] := -across[1]*across[2];
  slope[2] := axes[3]*axes[4]*(along[2]*across[1] - along[1]*across[2])
    + axes[4]*axes[4]*lag[1]*across[2] + axes[3]*axes[3]*lag[2]*across[1];
  reach[1] := axes[4]*along[1] + axes[3]*lag[1];
  reach[2] := axes[3]*across[1];
  reach[3] := axes[3]*along[2] - axes[4]*lag[2];
  reach[4] := axes[4]*across[2];
  still[1] := h[2] - (reach[1]*base[1] + reach[2]*base[2])*inverse;
  still[2] := h[3] + (reach[3]*base[1] - reach[4]*base[2])*inverse;
  push[1] := -(axes[4]*across[1] + (reach[1]*slope[1] + reach[2]*slope[2])*inverse);
  push[2] := axes[3]*across[2] + (reach[3]*slope[1] - reach[4]*slope[2])*inverse;
  drift := (amplitude*still[2] - quadrature*still[1])*spread;
  response := (amplitude*push[2] - quadrature*push[1])*spread;
  swing := (amplitude*still[1] - quadrature*still[2])*spread;
  reaction := (amplitude*push[1] - quadrature*push[2])*spread;
  on := if driveOn > 0 then 1 else 0;
  node := on*(if rebalance > 0 then (wanted[1] - drift)/response else driveOn*2*patternRate*detected);
  antinode := on*(base[1] + slope[1]*node)*inverse;
  square := on*(base[2] + slope[2]*node)*inverse;
  forces[1] := (1 - parametricShare)*antinode;
  forces[2] := square;
  forces[3] := node;
  motion := if authority > 0 or driveOn <= 0
    then boundedMotion(
      forces,
      {h[1] + antinode*(axes[3]*pump[1] - axes[4]*pump[2]), h[2] - antinode*(axes[3]*pump[2] + axes[4]*pump[1]),
       h[3] + antinode*(axes[3]*pump[3] - axes[4]*pump[4]), h[4] - antinode*(axes[3]*pump[4] + axes[4]*pump[3])},
      amplitude, quadrature, axes, aim, gain, authority)
    else {drift + response*node, wanted[2], wanted[3], swing + reaction*node, forces[1], square, node, 0};
  result[1] := motion[1];
  result[2] := motion[2];
  result[3] := motion[3];
  result[4] := wanted[4];
  result[5] := motion[5] + parametricShare*antinode;
  result[6] := motion[6];
  result[7] := motion[7];
  result[8] := motion[4] - wanted[4];
  result[9] := node - motion[7];
  result[10] := on*(1 - motion[8]);
  annotation (Documentation(info="<html>
<p>In the frame of the orbit, exp(-i phi) Z' has the antinode component a' + i (a psi + q alpha') and the node component
(a alpha' + q psi) - i q', with psi = phi' + nu, nu the reference's frequency. The drive adds A, N and -i S along the
detected axes, through the drives' gain, or parametric drive its share of A along the true ones. The amplitude and quadrature loops choose A and S so that a' and q' are what they want,
the phase loop chooses nu, the force-to-rebalance loop N: linear equations, solved here exactly in all electrode errors.
What is left is the motion of the pattern: the averaged equations of D. D. Lynch with the loops closed.</p>
</html>"));
end precession;
