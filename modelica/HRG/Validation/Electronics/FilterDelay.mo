within HRG.Validation.Electronics;
model FilterDelay "Filter delay td of the demodulation: an angle of -W td, and a scale-factor error of -td/tau"
  extends BaseClasses.Turning(gyro(controller(demodulation(filterDelay = present*delay))));
  parameter Units.Time delay = 2e-3 "td";
equation
  measured = angleError;
  expected = -delay*(rate + caseAngle/tau);
  scale = delay*rate;
  annotation (experiment(StopTime = 50), Documentation(info="<html>
<p>The reading is that of the pattern td ago. Forces are aimed by it, as with a loop delay (mechanism 15). Mechanism 39.</p>
</html>"));
end FilterDelay;
