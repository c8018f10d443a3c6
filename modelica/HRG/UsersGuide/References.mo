within HRG.UsersGuide;
class References "Sources of the equations"
  annotation (DocumentationClass = true, Documentation(info="<html>
<ul>
<li>D. D. Lynch, Vibratory gyro analysis by the method of averaging, Proc. 2nd St. Petersburg Int. Conf. on Gyroscopic
Technology and Navigation (1995): the averaged equations of amplitude, quadrature, pattern angle and phase.</li>
<li>D. Senkal and A. M. Shkel, Whole-Angle MEMS Gyroscopes, Wiley-IEEE Press (2020): the same in the form used here.</li>
<li>Xu et al. (2024), &quot;the paper&quot;: H. Xu, W. Liang, L. Qiu, M. Fan, C. Niu, Research on testing method of rate-integrating
hemispherical resonator gyroscope, doi:10.19306/j.cnki.2095-8110.2024.02.001. Its Eq. (1), (5) and (7) stand here with axes, factors and signs mended.</li>
<li>R. Adler, A study of locking phenomena in oscillators, Proc. IRE 34 (1946): lock-in.</li>
<li>IEEE Std 952: Allan deviation and its noise terms.</li>
</ul>
<p>Error mechanisms are numbered as in Mechanisms, the catalogue.</p>
</html>"));
end References;
