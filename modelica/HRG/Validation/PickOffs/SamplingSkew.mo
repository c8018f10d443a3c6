within HRG.Validation.PickOffs;
model SamplingSkew "Electrodes read in turn: an angle of W (ts/2)(1 + cos 4 theta)"
  extends BaseClasses.Turning(tolerance = 0.005, gyro(pickOff(samplingSkew = present*skew)));
  parameter Units.Time skew = 1e-4 "ts, of y after x";
equation
  measured = angleError;
  expected = rate*skew/2*(1 + cos(4*theta));
  scale = rate*skew;
  annotation (experiment(StopTime = 2), Documentation(info="<html>
<p>As mechanism 4 with d = -2k W ts: a non-orthogonality that goes with the rate. Half of it is the mean age of the reading. Mechanism 34.</p>
</html>"));
end SamplingSkew;
