package HRG "Whole-angle hemispherical resonator gyro: resonator, electrodes and control electronics"
  annotation (version = "0.1.0", uses(), Documentation(info="<html>
<p>The single source of the physics of this project. A gyro is assembled in <code>HRG.Gyroscopes</code>
from a resonator, its pick-off and drive electrodes, noise sources and a sampled controller; every part is
an ordinary Modelica block, and no part knows how it is going to be exported or run.</p>
<p>Angles called <em>pattern angle</em> are physical: the azimuth of the antinode, period 90 degrees up to
the sign of the wave. Angles called <em>modal</em> live in the plane of the two modal displacements and are
twice as large. The displacement is relative to the nominal antinode amplitude.</p>
</html>"));
end HRG;
