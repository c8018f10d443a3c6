within HRG.Controls;
block DampingCancellation "Pattern rate that cancels damping anisotropy by force"
  parameter Units.DampingCoefficient dampingAnisotropy(min = 0, max = 1e-2) = 0 "D as calibrated, typically 0.1 to 2 % of 1/tau" annotation(Evaluate = false);
  parameter Units.Angle dampingAxis(min = -1000, max = 1000) = 0 "Its axis of maximum damping" annotation(Evaluate = false);
  input Units.DimensionlessRatio cosine "Of the modal angle 2 theta";
  input Units.DimensionlessRatio sine "Of the modal angle 2 theta";
  output Units.AngularVelocity patternRate "Rate to be driven";
protected
  final parameter Units.DampingCoefficient quarterCos = dampingAnisotropy/4*cos(4*dampingAxis) "D/4 cos 4 theta_tau";
  final parameter Units.DampingCoefficient quarterSin = dampingAnisotropy/4*sin(4*dampingAxis) "D/4 sin 4 theta_tau";
equation
  patternRate = quarterSin*(cosine*cosine - sine*sine) - quarterCos*2*cosine*sine;
  annotation (Documentation(info="<html>
<p>The paper's Eq. (7) with its factors mended: damping drives the pattern at (D/4) sin 4(theta - theta_tau), so
that -(D/4) sin 4(theta - theta_tau) is driven against it and no dead zone is left.</p>
</html>"));
end DampingCancellation;
