within Strapdown.Algebra;
function rotationChange "Quaternion of a rotation vector less (1, 0, 0, 0)"
  input Real v[3] "Rotation vector, rad";
  output Real change[4] "Its quaternion less (1, 0, 0, 0)";
protected
  Real s "Square of the angle";
  Real angle "Angle of the rotation, 0.2 rad at least";
  Real factor "Of the rotation vector";
  Real small[4] "The change by power series";
algorithm
  s := v[1]*v[1] + v[2]*v[2] + v[3]*v[3];
  angle := sqrt(if s < 0.04 then 0.04 else s);
  factor := sin(0.5*angle)/angle;
  small := smallRotationChange(v);
  change := if s < 0.04 then small else {-2*sin(0.25*angle)^2, factor*v[1], factor*v[2], factor*v[3]};
  annotation (Documentation(info="<html>
<p>Without cancellation: the scalar part is -2 sin^2(x/4) at the angle x; below 0.2 rad by <code>smallRotationChange</code>.</p>
</html>"));
end rotationChange;
