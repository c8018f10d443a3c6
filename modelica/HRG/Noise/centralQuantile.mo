within HRG.Noise;
function centralQuantile "Quantile of the normal distribution for probabilities within 0.49 of the median"
  input Real q "Probability less one half";
  output Real quantile "Normal quantile, relative error below 1e-9";
protected
  Real s "Square of q, brought to -1 to 1";
algorithm
  s := 8.329862557267806*q*q - 1;
  quantile := q
    *((((((0.0054353253574168925*s - 0.24094814659690697)*s + 2.085867768156681)*s - 7.229920605988005)*s + 12.004639702300098)*s - 9.569279759886662)*s + 2.948094204210258)
    /((((((0.00758311536957823*s - 0.16421354994318896)*s + 1.0762563110819825)*s - 3.171980919292821)*s + 4.7153814310954)*s - 3.462207353924893)*s + 1.0);
  annotation (Documentation(info="<html>
<p>Rational minimax approximation of degree 6 in the square of q, fitted to the relative error; a wide centre leaves
2 % to <code>tailQuantile</code>, which costs a logarithm.</p>
</html>"));
end centralQuantile;
