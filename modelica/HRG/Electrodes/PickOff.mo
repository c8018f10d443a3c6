within HRG.Electrodes;
block PickOff "Displacement as the electronics see it"
  extends PartialPickOff;
  parameter Units.Time forceTime = feedthrough "Reads this time the force as well, in all";
  Interfaces.Inputs.RelativeDisplacement displacement[4] "True displacement {cx, sx, cy, sy}"
    annotation (Placement(transformation(extent = {{-120, 7}, {-100, 27}})));
  Interfaces.Inputs.RelativeForce force[4] "Force in action at the moment of sampling"
    annotation (Placement(transformation(extent = {{-120, -60}, {-100, -40}})));
  output Units.RelativeDisplacement analogue[4] "Reading before noise and conversion";
protected
  Units.RelativeDisplacement y[2] "y with the share of x";
  Units.DimensionlessRatio swing[2] "Gain of x and y at the present amplitude";
equation
  y = {displacement[3] + share*displacement[1], displacement[4] + share*displacement[2]};
  swing = {
    gain[1]*(1 + 0.75*cubic*(displacement[1]^2 + displacement[2]^2)),
    gain[2]*(1 + 0.75*cubic*(y[1]^2 + y[2]^2))};
  analogue = {
    swing[1]*(phasor[1]*displacement[1] + phasor[2]*displacement[2]) + offset + forceTime*force[1],
    swing[1]*(phasor[1]*displacement[2] - phasor[2]*displacement[1]) + forceTime*force[2],
    swing[2]*(phasor[3]*y[1] + phasor[4]*y[2]) + offsetY + forceTime*force[3],
    swing[2]*(phasor[3]*y[2] - phasor[4]*y[1]) + forceTime*force[4]};
  reading = {
    digitised(analogue[1] + noise[1], resolution, fullScale),
    digitised(analogue[2] + noise[2], resolution, fullScale),
    digitised(analogue[3] + noise[3], resolution, fullScale),
    digitised(analogue[4] + noise[4], resolution, fullScale)};
  annotation (Documentation(info="<html>
<p>With X = cx - i sx the envelope of x, F that of the force in action on it, reading = Q(gain (1 + 3/4 b |X|^2) X exp(i p) + offset +
forceTime F + noise), y alike after y + d x: a cubic b x^3 gives 3/4 b |X|^2 X at the carrier. Q is <code>digitised</code>.</p>
</html>"));
end PickOff;
