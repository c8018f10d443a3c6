within HRG.Electrodes;
function ringErrors "Errors of pick-offs, drives and softening by an uneven gap, as sums over the electrodes"
  input Real electrodes "Electrodes of the ring: 8 or 16";
  input Real halfWidth "Half an electrode's width, rad";
  input Real gapCos[4] "Cosine harmonics 1 to 4 of the gap, over its mean";
  input Real gapSin[4] "Sine harmonics 1 to 4 of the gap, over its mean";
  output Real errors[9] "Pick-offs {scale less one, g, d}, drives {scale less one, gd, nd, e}, softening {cos, sin of four times the angle}, over its mean";
protected
  Real node[5] "Gauss-Legendre nodes of half widths";
  Real weight[5] "Their weights";
  Real center "Azimuth of an electrode";
  Real azimuth "Azimuth of a node";
  Real gap "Over its mean, less one";
  Real gain "Excess of the pick-off's gain, weighted";
  Real stiffness "Softening, weighted";
  Real x "Weight of the electrode for x";
  Real y "Weight of the electrode for y";
  Real reading[4] "Matrix of the pick-offs by rows, less the even gap's";
  Real normal[2] "Diagonal of the even gap's";
  Real softening[3] "Mean, cosine and sine";
  Real lumps[4] "As of gainErrors";
  Real c "Cosine of the pick-offs' rotation";
  Real s "Sine of the pick-offs' rotation";
algorithm
  node := {-0.906179845938664, -0.5384693101056831, 0, 0.5384693101056831, 0.906179845938664};
  weight := {0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  reading := {0, 0, 0, 0};
  normal := {0, 0};
  softening := {0, 0, 0};
  for j in 0:15 loop
    center := 2*Constants.pi*j/electrodes;
    x := cos(2*center);
    y := sin(2*center);
    for i in 1:5 loop
      azimuth := center + halfWidth*node[i];
      gap := gapCos[1]*cos(azimuth) + gapSin[1]*sin(azimuth) + gapCos[2]*cos(2*azimuth) + gapSin[2]*sin(2*azimuth)
        + gapCos[3]*cos(3*azimuth) + gapSin[3]*sin(3*azimuth) + gapCos[4]*cos(4*azimuth) + gapSin[4]*sin(4*azimuth);
      gain := weight[i]*(1/(1 + gap)^2 - 1);
      stiffness := weight[i]/((1 + gap)*(1 + gap)^2);
      reading[1] := reading[1] + gain*x*cos(2*azimuth);
      reading[2] := reading[2] + gain*x*sin(2*azimuth);
      reading[3] := reading[3] + gain*y*cos(2*azimuth);
      reading[4] := reading[4] + gain*y*sin(2*azimuth);
      normal[1] := normal[1] + weight[i]*x*cos(2*azimuth);
      normal[2] := normal[2] + weight[i]*y*sin(2*azimuth);
      softening[1] := softening[1] + stiffness;
      softening[2] := softening[2] + (stiffness - weight[i])*cos(4*azimuth);
      softening[3] := softening[3] + (stiffness - weight[i])*sin(4*azimuth);
    end for;
  end for;
  reading[1] := 1 + reading[1]/normal[1];
  reading[2] := reading[2]/normal[1];
  reading[3] := reading[3]/normal[2];
  reading[4] := 1 + reading[4]/normal[2];
  lumps := gainErrors(reading[1], reading[2], reading[3], reading[4]);
  c := cos(lumps[4]);
  s := sin(lumps[4]);
  errors[1] := lumps[1];
  errors[2] := lumps[2];
  errors[3] := lumps[3];
  lumps := gainErrors(
    c*reading[1] - s*reading[2], c*reading[3] - s*reading[4],
    s*reading[1] + c*reading[2], s*reading[3] + c*reading[4]);
  errors[4] := lumps[1];
  errors[5] := lumps[2];
  errors[6] := lumps[3];
  errors[7] := lumps[4];
  errors[8] := softening[2]/softening[1];
  errors[9] := softening[3]/softening[1];
  annotation (Documentation(info="<html>
<p>Integrals over an electrode by five Gauss-Legendre nodes, right to 1e-6 of an error. Sixteen steps of 2 pi/n go once or twice round the ring. Axes are the
x pick-off's, as everywhere in the library: what turns the pick-offs turns the drives against them, and is no error of its own.</p>
</html>"));
end ringErrors;
