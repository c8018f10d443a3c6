within HRG.Validation;
package Precession "Where the pattern goes: locked, free or turned"
  annotation (Documentation(info="<html>
<p>Adler's equation of a pattern with damping anisotropy: it locks, slips or is turned by force.</p>
</html>"));
end Precession;
