within Strapdown.Mechanization;
function rotationIntegrals "(1 - cos x)/x^2, (x - sin x)/x^3 and (x^2/2 - 1 + cos x)/x^4"
  input Real s "Square of the angle x, rad2";
  output Real factors[3] "The three factors";
protected
  Real x "Angle, 0.2 rad at least";
  Real versine "1 - cos x";
algorithm
  x := sqrt(if s < 0.04 then 0.04 else s);
  versine := 1 - cos(x);
  factors := if s < 0.04 then {
    1/2 - s/24*(1 - s/30*(1 - s/56*(1 - s/90))),
    1/6 - s/120*(1 - s/42*(1 - s/72*(1 - s/110))),
    1/24 - s/720*(1 - s/56*(1 - s/90*(1 - s/132)))} else {
    versine/s,
    (x - sin(x))/(s*x),
    (s/2 - versine)/(s*s)};
  annotation (Documentation(info="<html>
<p>Eq. 4: factors of r x v and r x (r x v) in the integral and the double integral of a constant force in turning axes.</p>
</html>"));
end rotationIntegrals;
