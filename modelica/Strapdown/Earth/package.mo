within Strapdown;
package Earth "The ellipsoid and normal gravity of WGS-84"
  constant Real rate = 7.292115e-5 "Rotation rate of Earth, rad/s";
  constant Real semiMajor = 6378137.0 "Equatorial radius, m";
  constant Real flattening = 1/298.257223563 "Flattening of the ellipsoid";
  constant Real eccentricitySquared = flattening*(2 - flattening) "First eccentricity of the ellipsoid, squared";
  constant Real equatorGravity = 9.7803253359 "Normal gravity on the ellipsoid at the equator, m/s2";
  constant Real somigliana = 0.00193185265241 "Constant k of Somigliana's formula";
  constant Real gravityRatio = 0.00344978650684 "Centrifugal acceleration over gravitation at the equator";
  constant Real plumbLine = 8.08e-9 "Curvature of the plumb line: north gravity is -plumbLine h sin(2 latitude), 1/s2";
  annotation (Documentation(info="<html>
<p>NIMA TR8350.2; P. D. Groves, Principles of GNSS, inertial, and multisensor integrated navigation systems, 2nd ed. (2013). The numbers are those of
<code>ins_eval/common/earth.py</code>.</p>
</html>"));
end Earth;
