within HRG.Validation.Electronics;
model TimeDivisionAge "Drive and sense in time division: every second output is a period old, an angle of -W Ts"
  extends BaseClasses.Turning(
    redeclare final model Gyro = Gyroscopes.HRGEnvelope,
    gyro(controller(timeDivision = present)));
equation
  measured = angleError;
  expected = -rate*controlPeriod;
  scale = rate*controlPeriod;
  annotation (experiment(StopTime = 2.001), Documentation(info="<html>
<p>Readings are fresh at even multiples of Ts; the stop time is an odd one. Mechanism 40. <code>HRGSlow</code> reads where readings are fresh.</p>
</html>"));
end TimeDivisionAge;
