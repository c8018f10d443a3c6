within HRG.Validation;
package ElectrodeRing "An uneven gap between shell and electrodes"
  annotation (Documentation(info="<html>
<p>What the harmonics of the gap make of gains and frequencies, by sums over the electrodes.</p>
</html>"));
end ElectrodeRing;
