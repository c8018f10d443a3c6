within Strapdown.Mechanization;
function start "State of the navigator at the start"
  input Real position[3] "{latitude, rad; longitude, rad; height, m}";
  input Real velocity[3] "North, east, down, m/s";
  input Real heading "Clockwise from north, rad";
  input Real pitch "Nose up, rad";
  input Real roll "Right side down, rad";
  output Real state[17] "State, as of function step";
protected
  Real ch "Cosine of half the heading";
  Real sh "Sine of half the heading";
  Real cp "Cosine of half the pitch";
  Real sp "Sine of half the pitch";
  Real cr "Cosine of half the roll";
  Real sr "Sine of half the roll";
algorithm
  ch := cos(0.5*heading);
  sh := sin(0.5*heading);
  cp := cos(0.5*pitch);
  sp := sin(0.5*pitch);
  cr := cos(0.5*roll);
  sr := sin(0.5*roll);
  state := {
    position[1], position[2], position[3],
    velocity[1], velocity[2], velocity[3],
    ch*cp*cr + sh*sp*sr,
    ch*cp*sr - sh*sp*cr,
    ch*sp*cr + sh*cp*sr,
    sh*cp*cr - ch*sp*sr,
    0, 0, 0, 0, 0, 0, 0};
  annotation (Documentation(info="<html>
<p>The attitude is the rotation by roll about forward, then by pitch about right, then by heading about down.</p>
</html>"));
end start;
