within HRG.Noise;
function normalQuantile "Quantile of the standard normal distribution, relative error below 1e-15"
  input Real probability "Within (0, 1)";
  output Real quantile "Value that a normal deviate stays below with that probability";
protected
  Real q "Distance from the median";
algorithm
  q := probability - 0.5;
  quantile :=
    if abs(q) <= 0.425 then q*centralQuantile(0.180625 - q*q)
    elseif q < 0 then -tailQuantile(sqrt(-log(probability)) - 1.6)
    else tailQuantile(sqrt(-log(1 - probability)) - 1.6);
  annotation (Documentation(info="<html>
<p>Algorithm AS 241, PPND16: M. J. Wichura, The percentage points of the normal distribution,
Applied Statistics 37 (1988). Deviates of 32 bits never reach its far tail (beyond exp(-25) = 1.4e-11).</p>
</html>"));
end normalQuantile;
