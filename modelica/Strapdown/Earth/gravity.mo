within Strapdown.Earth;
function gravity "Normal gravity, positive down, m/s2"
  input Real latitude "Geodetic latitude, rad";
  input Real height "Above the ellipsoid, m";
  output Real down "Normal gravity, m/s2";
protected
  Real s "Square of the latitude's sine";
  Real surface "Gravity on the ellipsoid, m/s2";
  Real ratio "Height over the equatorial radius";
  Real slope "Half the relative decrease of gravity with that ratio";
algorithm
  s := sin(latitude)^2;
  surface := equatorGravity*(1 + somigliana*s)/sqrt(1 - eccentricitySquared*s);
  ratio := height/semiMajor;
  slope := 1 + flattening + gravityRatio - 2*flattening*s;
  down := surface*(1 - 2*slope*ratio + 3*ratio^2);
  annotation (Documentation(info="<html>
<p>To second order in the height: NIMA TR8350.2, Eqs. 4-1 and 4-3.</p>
</html>"));
end gravity;
