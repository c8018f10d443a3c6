within Strapdown.Mechanization;
function attitudeChange "Change of the attitude's quaternion over a step"
  input Real q[4] "Attitude, from body to navigation axes";
  input Real turned[3] "Rotation vector of the body, rad";
  input Real turn[3] "Rotation vector of the navigation axes, rad";
  output Real change[4] "Change of the quaternion";
protected
  Real byBody[4] "Change by the body's rotation, and to unit length";
  Real excess "Half of what the squared length lacks of 1";
algorithm
  excess := 0.5 - 0.5*(q[1]*q[1] + q[2]*q[2] + q[3]*q[3] + q[4]*q[4]);
  byBody := Algebra.product(q, Algebra.rotationChange(turned)) + excess*q;
  change := byBody + Algebra.product(Algebra.smallRotationChange(-turn), q + byBody);
  annotation (Documentation(info="<html>
<p>Eq. 16.</p>
</html>"));
end attitudeChange;
