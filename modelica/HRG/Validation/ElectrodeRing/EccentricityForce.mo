within HRG.Validation.ElectrodeRing;
model EccentricityForce "A shell off the centre: pick-offs and drives gain 3/2 of the square of the eccentricity each"
  extends BaseClasses.GrowthAtRest(tolerance = 0.01, gyro(ring(eccentricity = present*eccentricity, eccentricityAxis = 0.5)));
  parameter Units.DimensionlessRatio eccentricity = 0.03 "Over the mean gap";
equation
  expected = -3*eccentricity^2/tau;
  scale = 3*eccentricity^2/tau;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>Less force for a smaller vibration, wherever the pattern stands; nothing else is seen to fourth order: read as amplitude, it is no error of the angle.
Mechanism 32.</p>
</html>"));
end EccentricityForce;
