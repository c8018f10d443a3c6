within HRG;
package Resonators "The vibrating shell"
  annotation (Documentation(info="<html>
<p>The shell with its environment and material (<code>PartialResonator</code>), and its motion in three forms: as an envelope, at the
carrier, as an orbit. A resonator takes forces and gives displacements, both relative to the nominal amplitude.</p>
</html>"));
end Resonators;
