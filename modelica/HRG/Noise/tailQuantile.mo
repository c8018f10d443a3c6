within HRG.Noise;
function tailQuantile "Quantile of the normal distribution for probabilities within 0.01 of 0 or 1, down to exp(-25)"
  input Real probability "Within (0, 1)";
  output Real quantile "Normal quantile, relative error below 1e-15";
protected
  Real r "Argument of the rational approximation";
algorithm
  r := sqrt(-log(if probability < 0.5 then probability else 1 - probability)) - 1.6;
  quantile := (if probability < 0.5 then -1 else 1)
    *(((((((7.7454501427834140764e-4*r + 0.0227238449892691845833)*r + 0.24178072517745061177)*r + 1.27045825245236838258)*r + 3.64784832476320460504)*r + 5.7694972214606914055)*r + 4.6303378461565452959)*r + 1.42343711074968357734)
    /(((((((1.05075007164441684324e-9*r + 5.475938084995344946e-4)*r + 0.0151986665636164571966)*r + 0.14810397642748007459)*r + 0.68976733498510000455)*r + 1.6763848301838038494)*r + 2.05319162663775882187)*r + 1.0);
  annotation (Documentation(info="<html>
<p>Algorithm AS 241, PPND16, its intermediate range: M. J. Wichura, The percentage points of the normal distribution,
Applied Statistics 37 (1988).</p>
</html>"));
end tailQuantile;
