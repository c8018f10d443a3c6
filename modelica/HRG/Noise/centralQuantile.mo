within HRG.Noise;
function centralQuantile "Quantile of the normal distribution for probabilities within 0.425 of the median (AS 241)"
  input Real q "Probability less one half";
  output Real quantile "Normal quantile, relative error below 1e-15";
protected
  Real r "Argument of the rational approximation";
algorithm
  r := 0.180625 - q*q;
  quantile := q
    *(((((((2509.0809287301226727*r + 33430.575583588128105)*r + 67265.770927008700853)*r + 45921.953931549871457)*r + 13731.693765509461125)*r + 1971.5909503065514427)*r + 133.14166789178437745)*r + 3.387132872796366608)
    /(((((((5226.495278852854561*r + 28729.085735721942674)*r + 39307.89580009271061)*r + 21213.794301586595867)*r + 5394.1960214247511077)*r + 687.1870074920579083)*r + 42.313330701600911252)*r + 1.0);
end centralQuantile;
