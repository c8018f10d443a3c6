package Strapdown "Strapdown navigator and accelerometers: what stands beside the gyros in a system"
  annotation (version = "0.1.0", uses(HRG(version = "0.1.0")), Documentation(info="<html>
<p>The parts of an inertial navigation system that are no gyro. Like the gyros they become FMUs. The navigator's equations are those of
<code>ins_eval/navigation</code>, to which a test holds them; equation numbers here and there are those of
<code>docs/methods/navigation.md</code>. Axes: navigation axes are north, east, down; body axes forward, right, down.</p>
</html>"));
end Strapdown;
