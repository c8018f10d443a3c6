within HRG.Validation.MassDefects;
model VibrationBias "Vibration of the case at the modal frequency, in three directions, on harmonics 1 to 3 of the mass"
  extends BaseClasses.BiasAtRest(
    gyro(
      vibration = vibration,
      resonator(massDefects(
        first = present*first, firstAxis = 0.4,
        second = present*second, secondAxis = 0.9,
        third = present*third, thirdAxis = 0.2,
        vibrationForce = {fX, fY, fZ}))));
  parameter Units.Acceleration vibration = 1e-3 "Of the case, in phase";
  parameter Units.DimensionlessRatio first = 2e-3 "m1";
  parameter Units.DimensionlessRatio second = 1e-3 "m2";
  parameter Units.DimensionlessRatio third = 5e-4 "m3";
  parameter Real fX(unit = "s/m") = 3 "Force over vibration, along x";
  parameter Real fY(unit = "s/m") = -2 "Force over vibration, along y";
  parameter Real fZ(unit = "s/m") = 4 "Force over vibration, along z";
equation
  measured = bias.rate;
  expected = -vibration/(2*k)*(
    0.75*first*(fX*sin(2*theta - 0.4) + fY*(-sin(0.4)*sin(2*theta) - cos(0.4)*cos(2*theta)))
    + third/4*(fX*sin(2*theta - 0.6) + fY*(sin(0.6)*sin(2*theta) + cos(0.6)*cos(2*theta)))
    + second/2*fZ*sin(2*(theta - 0.9)));
  scale = vibration/(2*k)*(0.75*first*3.6 + third/4*3.6 + second/2*4);
  annotation (experiment(StopTime = 30), Documentation(info="<html>
<p>A sway takes the first and third harmonic, a heave the second; a second harmonic of the bias as in mechanism 27. Mechanism 35.</p>
</html>"));
end VibrationBias;
