within Strapdown.Algebra;
function smallRotationChange "Quaternion of a rotation vector below 0.2 rad less (1, 0, 0, 0)"
  input Real v[3] "Rotation vector, rad";
  output Real change[4] "Its quaternion less (1, 0, 0, 0)";
protected
  Real s "Square of the angle";
  Real factor "Of the rotation vector";
algorithm
  s := v[1]*v[1] + v[2]*v[2] + v[3]*v[3];
  factor := 0.5 - s/48*(1 - s/80*(1 - s/168*(1 - s/288)));
  change := {-s/8*(1 - s/48*(1 - s/120*(1 - s/224))), factor*v[1], factor*v[2], factor*v[3]};
  annotation (Documentation(info="<html>
<p>Power series: without cancellation, and the first term left out is below rounding.</p>
</html>"));
end smallRotationChange;
