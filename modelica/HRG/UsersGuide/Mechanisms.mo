within HRG.UsersGuide;
class Mechanisms "Catalogue of error mechanisms and modes: where each is a parameter, and its closed form"
  annotation (DocumentationClass = true, Documentation(info="<html>
<p>Zero by default. Closed forms hold at rest with the loops closed unless they say otherwise, to first order; th is
the pattern angle, c4 = cos 4 th, s4 = sin 4 th, ' counted from th_tau, '' from th_w. B: output bias; G: growth
rate (<code>amplitudeForce</code>); N: <code>quadratureForce</code>; P: <code>frequencyOffset</code>. The other symbols are
those of Conventions. W is the inertial rate of the case: an error of the angle, f(th), is a rate error of -k W df/dth besides its bias, on the
Earth too, whose rate is 9.65 deg/h about a vertical axis at 39.9 degrees of latitude. Each line is demonstrated by models of <code>HRG.Validation</code>, which name its number.</p>
<table border=\"1\">
<tr><th>#</th><th>mechanism</th><th>parameter or input</th><th>closed form</th></tr>
<tr><td>1</td><td>damping anisotropy</td><td><code>resonator.material.dampingAnisotropy</code>, <code>dampingAxis</code></td><td>B = -(D/4k) s4', G = 1/tau + (D/2) c4'</td></tr>
<tr><td>2</td><td>pick-off gain mismatch</td><td><code>pickOff.gainMismatch</code></td><td>angle +(g/4k) s4, so a rate error of -W g c4; B = +(g/4k tau) s4, G -(g/2 tau) c4; second order: scale factor -g (g + gd)/4</td></tr>
<tr><td>3</td><td>drive gain mismatch</td><td><code>drive.gainMismatch</code></td><td>B and G as 2, nothing in the angle; with 2, under a virtual rotation R: rate +((g + gd)/2) R c4</td></tr>
<tr><td>4</td><td>pick-off non-orthogonality</td><td><code>pickOff.nonOrthogonality</code></td><td>angle -(d/4k)(1 + c4), so a rate error of -W d s4; B = -(d/4k tau)(1 + c4), G -(d/2 tau) s4</td></tr>
<tr><td>5</td><td>drive non-orthogonality</td><td><code>drive.nonOrthogonality</code></td><td>B and G as 4, nothing in the angle; with 4, under a virtual rotation R: rate +((d + nd)/2) R s4</td></tr>
<tr><td>6</td><td>drive frame rotation</td><td><code>drive.frameRotation</code></td><td>B = -e/(2k tau)</td></tr>
<tr><td>7</td><td>frequency split with phase error</td><td><code>resonator.material.frequencySplit</code>, <code>stiffnessAxis</code>; <code>pickOff.phaseError</code>, input <code>phaseOffset</code></td><td>B = -(dw p/4k) s4'', N = (dw/2) s4'', P = -(dw/2) c4''</td></tr>
<tr><td>8</td><td>residual quadrature</td><td><code>controller.quadratureSetpoint</code></td><td>B = -(dw/2k) q0 c4'', N + q0/tau</td></tr>
<tr><td>9</td><td>split alone</td><td>as 7; <code>controller.quadratureLoop.naturalFrequency</code></td><td>at rest B = 0; in a case that turns, the loop of natural frequency w_q leaves q = 2 k W dw c4''/w_q^2, by 8 a rate error of -W (dw/w_q)^2 (1 + c8'')/2 (not in <code>HRGSlow</code>)</td></tr>
<tr><td>10</td><td>differential phase</td><td><code>pickOff.differentialPhase</code></td><td>with a split: 8th harmonic, dw p/16k</td></tr>
<tr><td>11</td><td>feedthrough</td><td><code>pickOff.feedthrough</code></td><td>with a split: B = (c dw^2/8k) s8''</td></tr>
<tr><td>12</td><td>demodulation offset</td><td><code>pickOff.offset</code>, <code>offsetY</code></td><td>2nd harmonic: angle (x0 sin 2 th - y0 cos 2 th)/2k, B as much over tau</td></tr>
<tr><td>13</td><td>pick-off cubic</td><td><code>pickOff.cubic</code></td><td>angle: 8th harmonic, 0.75 b a^2/(8k)</td></tr>
<tr><td>14</td><td>Duffing stiffness</td><td><code>resonator.material.duffing</code></td><td>P + delta a^2; with quadrature B = +delta a q/(3k) (the sign is that of this output; the wave's is opposite)</td></tr>
<tr><td>15</td><td>loop delay and hold</td><td><code>controller.synthesis.loopDelay</code></td><td>scale factor -(Ts/2 + td)/tau</td></tr>
<tr><td>16</td><td>Bryan factor</td><td><code>resonator.material.bryanFactor</code> against <code>controller.readout.bryanFactor</code>; <code>bryanFactorPerKelvin</code></td><td>scale factor</td></tr>
<tr><td>17</td><td>clock</td><td><code>controller.readout.clockError</code></td><td><code>gyroRate</code> -e, angle 0, P -e w</td></tr>
<tr><td>18</td><td>virtual rotation gain, noise</td><td><code>controller.readout.virtualRotationError</code>, <code>noise.virtualRotation</code></td><td>B = -e V; N = V times <code>noise.virtualRotation</code></td></tr>
<tr><td>19</td><td>lock-in</td><td>from 1</td><td>stops at sin 4(th - th_tau) = W/W_L for W &lt; W_L = D/4k; else mean rate sqrt(W^2 - W_L^2)</td></tr>
<tr><td>20</td><td>force noise</td><td><code>noise.angleRandomWalk</code></td><td>N, over amplitude</td></tr>
<tr><td>21</td><td>pick-off noise</td><td><code>noise.pickOff</code></td><td>white angle</td></tr>
<tr><td>22</td><td>rate random walk, flicker</td><td><code>noise.rateRandomWalk</code>, <code>noise.biasInstability</code></td><td>K; Allan deviation 0.664 B</td></tr>
<tr><td>23</td><td>frequency over temperature</td><td><code>resonator.material.frequencyPerKelvin</code>, <code>resonator.environment.thermalLag</code>; warm-up from <code>startTemperature</code> by <code>selfHeating</code></td><td>P; T - T_0 = T_s exp(-t/lag) + (T_c + T_h - T_0)(1 - exp(-t/lag))</td></tr>
<tr><td>24</td><td>tau, D, g, p over temperature; its rate</td><td><code>...PerKelvin</code>; <code>drive.rotationPerTemperatureRate</code>, <code>pickOff.gainPerGradient</code></td><td>as 1, 2, 7 scaled; B = -(e' dT/dt)/(2k tau); as 2 with g = g' (T_case - T): hysteresis, g' lag dT/dt on a ramp</td></tr>
<tr><td>25</td><td>bias voltage, charge</td><td>input <code>biasVoltage</code>; <code>electrostaticShift</code>, <code>electrostaticSplit</code>, <code>electrostaticAxis</code>; <code>pickOff.gainPerVoltage</code>, <code>drive.gainPerVoltage</code></td><td>P and N with V^2 - 1, at constant temperature; with both gains G = 1/(V^2 tau), and under virtual rotation B = -(V^2 - 1) times it</td></tr>
<tr><td>26</td><td>mounting</td><td><code>resonator.material.mountingDamping</code>, <code>mountingAxis</code></td><td>adds to 1 as a vector</td></tr>
<tr><td>27</td><td>imbalance, vibration at the modal frequency</td><td><code>resonator.imbalanceX</code>, <code>imbalanceY</code>, input <code>vibration</code></td><td>B = (f/2k) s2</td></tr>
<tr><td>28</td><td>specific force</td><td><code>pickOff.gainPerAcceleration</code>, <code>gainPerAccelerationSquared</code>, <code>drive.rotationPerAcceleration</code>, <code>resonator.material.splitPerAcceleration</code></td><td>as 2, 6, 7</td></tr>
<tr><td>29</td><td>input-axis misalignment</td><td>of the mounting: by the input <code>angularRate</code></td><td>H sin delta once a turn of the table</td></tr>
<tr><td>30</td><td>resolution, quantum of the output, full scale, drive authority</td><td><code>pickOff.resolution</code>, <code>controller.readout.quantum</code>, <code>pickOff.fullScale</code>, <code>drive.authority</code></td><td>steps, clipping; full range of rebalance f/(2k)</td></tr>
<tr><td>31</td><td>ageing of tau, D, g</td><td><code>resonator.material.decayTimeAgeing</code>, <code>dampingAnisotropyAgeing</code>, <code>pickOff.gainAgeing</code></td><td>G; as 1 with D (1 + r t), as 2 with g + r t</td></tr>
<tr><td>32</td><td>uneven gap of the electrodes</td><td><code>ring.fourthHarmonic</code>, <code>eccentricity</code>, <code>secondHarmonic</code>, <code>thirdHarmonic</code>, their axes; <code>ring.electrodes</code>, <code>coverage</code></td><td>as 2 to 6 with g = gd = -2 E cos 4 th_4, d = nd = -e = -2 E sin 4 th_4 (16 electrodes; <code>Electrodes.Ring</code> has 8); with 25 a split of 3 E electrostaticShift (V^2 - 1)</td></tr>
<tr><td>33</td><td>cubic softening by eight electrodes</td><td><code>resonator.material.electrostaticCubic</code></td><td>N = (delta/4) V^2 a^3 s8, P = -delta V^2 a^2 (3 + c8)/4; with phase error B = -(delta p/8k) V^2 a^2 s8</td></tr>
<tr><td>34</td><td>electrodes read in turn</td><td><code>pickOff.samplingSkew</code></td><td>angle +W (ts/2)(1 + c4); a virtual rotation R as W = -R</td></tr>
<tr><td>35</td><td>harmonics of the rim's mass</td><td><code>resonator.massDefects.first</code>, <code>second</code>, <code>third</code>, their axes; <code>lateralLoss</code>, <code>axialLoss</code>; <code>vibrationForce</code> with input <code>vibration</code></td><td>as 1 with D = (3/4) lateralLoss m1 m3 about (th_1 + 3 th_3)/4 and (1/4) axialLoss m2^2 about th_2; G + (9/16) lateralLoss m1^2; as 27</td></tr>
<tr><td>36</td><td>rectified vibration</td><td><code>pickOff.vibrationVariance</code> with <code>gainPerAccelerationSquared</code></td><td>as 2 with g = g_2 S df</td></tr>
<tr><td>37</td><td>anisotropy of parametric drive</td><td><code>drive.pumpAnisotropy</code>, <code>pumpAxis</code>; and from 32, n = -(3/2) E about its axis</td><td>with <code>parametricShare</code> = 1: B = (n/2k tau) sin 4(th - th_n), G -(n/tau) cos 4(th - th_n)</td></tr>
<tr><td>38</td><td>flicker of D, g and p</td><td><code>flicker.dampingAnisotropy</code> (relative to D), <code>flicker.gainMismatch</code>, <code>flicker.phaseError</code></td><td>as 1, 2, 7 with D (1 + x), g + x, p + x, x of density B^2/(2 pi f): at a fixed angle an Allan deviation of 0.664 B times the bias of 1, 2, 7 per unit; of g beside it the angle's</td></tr>
<tr><td>39</td><td>filter of the demodulation</td><td><code>controller.demodulation.filterDelay</code></td><td>angle -W td; a virtual rotation R as W = -R; scale factor -td/tau, as 15; loops stable for td &lt; 2/w; white noise of the reading times sqrt(Ts/(Ts + 2 td))</td></tr>
<tr><td>40</td><td>drive and sense in time division</td><td><code>controller.timeDivision</code></td><td>B = -(dw^2 Ts/16k) s8''; angle -W Ts at every second output (not in <code>HRGSlow</code>); no 11, half of <code>drive.authority</code></td></tr>
</table>
<p>The same gyro in its modes:</p>
<table border=\"1\">
<tr><th>mode</th><th>how</th></tr>
<tr><td>whole-angle</td><td>default</td></tr>
<tr><td>force-to-rebalance</td><td><code>controller.forceToRebalance = 1</code>: the pattern is held at the start angle</td></tr>
<tr><td>virtual rotation</td><td>input <code>virtualRotation</code>, an input rate: constant, reversing or swept as it is driven</td></tr>
<tr><td>mode reversal</td><td><code>controller.sweep.angle</code> = 45 degrees with rests (<code>controller.sweep.restTime</code>), in the force-to-rebalance mode: antinode and node change places, a fourth harmonic of the bias its sign. What the sweeps leave: (2/pi) of it, in their share of the time</td></tr>
<tr><td>dither of the pattern</td><td><code>controller.sweep.angle</code> = 90 degrees without rests, in either mode: every multiple of the fourth harmonic averages out. A gain error e of the rotation shows as -e times the position over k, and comes and goes</td></tr>
<tr><td>parametric drive</td><td><code>controller.parametricShare</code> = 1: the amplitude is held by a stiffness that is pumped at twice the frequency. What the force that sustains it made of 2 to 6 and 15 is gone (share s: 1 - s of it); 37 comes</td></tr>
<tr><td>two travelling waves</td><td>default: the pattern is two waves of amplitudes a + q and a - q, and their phases differ by 4 theta. <code>controller.quadratureSetpoint</code> = q makes them unequal: B = -(D/8k)(rho + 1/rho) sin 4(theta - theta_tau) - (dw/8k)(1/rho - rho) cos 4(theta - theta_w), rho their ratio</td></tr>
<tr><td>ring-down</td><td>input <code>driveOn = 0</code>: amplitude, quadrature and rotation forces off, phase tracking on</td></tr>
<tr><td>start-up</td><td><code>startAmplitude</code>, <code>controller.startUp.*</code>: a small vibration within 1 s, full amplitude at 10 s, output <code>valid</code></td></tr>
<tr><td>compensation of the output (the paper's Eq. 5)</td><td><code>controller.biasMap.*</code></td></tr>
<tr><td>compensation of the detected angle (Eqs. 2 and 3)</td><td><code>controller.scaleFactorMap.*</code></td></tr>
<tr><td>cancellation by force (Eq. 7, factors mended)</td><td><code>controller.cancellation.*</code></td></tr>
</table>
</html>"));
end Mechanisms;
