within HRG.Controls;
function pumpRates "What parametric drive gives to antinode and node"
  input Units.RelativeDisplacement amplitude "True antinode amplitude a";
  input Units.RelativeDisplacement quadrature "True quadrature q";
  input Units.DimensionlessRatio axes[4] "True {cosine and sine of the modal angle, cosine and sine of the phase}";
  input Units.DimensionlessRatio pumpGain[3] "Growth over command, of x, of y and between them";
  input Real pump "Command";
  output Real rates[4] "As of a force on the shell: {antinode in phase, a quarter of a period behind, node in phase, behind}";
protected
  Real along "Growth of the antinode by itself";
  Real between "Of the antinode by the node, and of the node by the antinode";
  Real across "Of the node by itself";
algorithm
  along := pump*(axes[1]*axes[1]*pumpGain[1] + axes[2]*axes[2]*pumpGain[2] + 2*axes[1]*axes[2]*pumpGain[3]);
  between := pump*(axes[1]*axes[2]*(pumpGain[2] - pumpGain[1]) + (axes[1]*axes[1] - axes[2]*axes[2])*pumpGain[3]);
  across := pump*(axes[2]*axes[2]*pumpGain[1] + axes[1]*axes[1]*pumpGain[2] - 2*axes[1]*axes[2]*pumpGain[3]);
  rates[1] := axes[3]*along*amplitude + axes[4]*between*quadrature;
  rates[2] := axes[4]*along*amplitude - axes[3]*between*quadrature;
  rates[3] := axes[3]*between*amplitude + axes[4]*across*quadrature;
  rates[4] := axes[4]*between*amplitude - axes[3]*across*quadrature;
  annotation (Documentation(info="<html>
<p>Z = exp(i phi) {a, -i q} on antinode and node, Z' = R Z* by parametric drive: exp(-i phi) Z' = exp(-2 i phi) R {a, i q}, R turned to the true axes. One factor exp(-i phi) is
left out, since a force has it as well. Without phase and quadrature, a' = R_aa a and the node moves by R_an a: an even pump turns nothing.</p>
</html>"));
end pumpRates;
