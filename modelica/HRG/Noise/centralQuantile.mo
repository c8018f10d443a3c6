within HRG.Noise;
function centralQuantile "Of the normal distribution: quantile over distance from the median, within 0.425 of the median"
  input Real r "0.425^2 less the squared distance of the probability from the median";
  output Real quantile "Rational approximation of AS 241";
algorithm
  quantile :=
    (((((((2509.0809287301226727*r + 33430.575583588128105)*r + 67265.770927008700853)*r + 45921.953931549871457)*r + 13731.693765509461125)*r + 1971.5909503065514427)*r + 133.14166789178437745)*r + 3.387132872796366608)
    /(((((((5226.495278852854561*r + 28729.085735721942674)*r + 39307.89580009271061)*r + 21213.794301586595867)*r + 5394.1960214247511077)*r + 687.1870074920579083)*r + 42.313330701600911252)*r + 1.0);
end centralQuantile;
