within HRG.Controls;
function isWhite "1 unless innovations are further from white than one in a thousand white ones, or too many are limited"
  input Real sums[7] "As of whitenessTest()";
  output Units.DimensionlessRatio result "1 or 0";
protected
  Real spread "Variance of the cube root of chi-square over its degrees of freedom";
  Real root "Cube root of the largest chi-square over its degrees of freedom";
algorithm
  spread := 2/(9*(if sums[5] > 0.5 then sums[5] else 1));
  root := 1 - spread + 3.0902*sqrt(spread);
  result := if sums[4] > sums[5]*root*root*root or sums[7] > 0.15*sums[6] then 0 else 1;
  annotation (Documentation(info="<html>
<p>The sum over windows of <code>whitenessTest</code> is chi-square with one degree of freedom a window. Its quantile is that of Wilson and Hilferty (Proc. Natl. Acad. Sci. 17, 1931, p. 684), 3.0902 the normal one.</p>
</html>"));
end isWhite;
