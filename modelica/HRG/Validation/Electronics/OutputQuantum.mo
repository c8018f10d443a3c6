within HRG.Validation.Electronics;
model OutputQuantum "Quantum q of the output angle: the angle read is rounded to it, and no error builds up"
  extends BaseClasses.Turning(gyro(controller(readout(quantum = present*quantum))));
  parameter Units.Angle quantum = 0.03 "q";
  parameter Units.Time duration = 50 "Until the stop time";
protected
  final parameter Units.Angle turned = (1 + holdError)*rate*duration "Angle before rounding, at the stop time";
equation
  measured = angleError;
  expected = quantum*floor(turned/quantum + 0.5) - turned;
  scale = quantum/2;
  annotation (experiment(StopTime = 50), Documentation(info="<html>
<p>Mechanism 30: the output is the nearest multiple of q, after any turn.</p>
</html>"));
end OutputQuantum;
