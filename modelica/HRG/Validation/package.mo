within HRG;
package Validation "One claim a model: what the gyro shows, beside its closed form"
  annotation (Documentation(info="<html>
<p>Every error mechanism and mode has a model here, in which nothing else is wrong with the gyro. It says what it
measures, what the closed form of its parameters gives, and how large the difference may be
(<code>BaseClasses.Claim</code>). Reference results of the same names lie in <code>Resources/ReferenceResults</code>.</p>
</html>"));
end Validation;
