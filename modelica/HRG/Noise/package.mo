within HRG;
package Noise "Reproducible noise: white, random walk, flicker"
  annotation (Documentation(info="<html>
<p>All randomness of a gyro: generators that start from one <code>seed</code>, the same on every machine, and the noises that are made of
their deviates.</p>
</html>"));
end Noise;
