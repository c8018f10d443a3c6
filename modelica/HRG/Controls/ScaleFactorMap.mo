within HRG.Controls;
block ScaleFactorMap "Error of the detected pattern angle as calibrated, to take out of the output"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.Angle cos2(min = -0.1, max = 0.1) = 0 "Coefficient of cos 2 theta, typically up to 5e-5" annotation(Evaluate = false);
  parameter Units.Angle sin2(min = -0.1, max = 0.1) = 0 "Coefficient of sin 2 theta, typically up to 5e-5" annotation(Evaluate = false);
  parameter Units.Angle cos4(min = -0.1, max = 0.1) = 0 "Coefficient of cos 4 theta, typically 2.5e-6 to 5e-4" annotation(Evaluate = false);
  parameter Units.Angle sin4(min = -0.1, max = 0.1) = 0 "Coefficient of sin 4 theta, typically 2.5e-6 to 5e-4" annotation(Evaluate = false);
  parameter Units.Angle cos8(min = -0.1, max = 0.1) = 0 "Coefficient of cos 8 theta, typically up to 1e-5" annotation(Evaluate = false);
  parameter Units.Angle sin8(min = -0.1, max = 0.1) = 0 "Coefficient of sin 8 theta, typically up to 1e-5" annotation(Evaluate = false);
  input Units.DimensionlessRatio cosine "Of the modal angle 2 theta";
  input Units.DimensionlessRatio sine "Of the modal angle 2 theta";
  discrete output Units.Angle error(start = 0, fixed = true) "Error of the detected pattern angle";
protected
  discrete Units.DimensionlessRatio c4(start = 1, fixed = true) "cos 4 theta";
  discrete Units.DimensionlessRatio s4(start = 0, fixed = true) "sin 4 theta";
equation
  when tick then
    c4 = cosine*cosine - sine*sine;
    s4 = 2*cosine*sine;
    error = cos2*cosine + sin2*sine + cos4*c4 + sin4*s4 + cos8*(c4*c4 - s4*s4) + sin8*2*c4*s4;
  end when;
  annotation (Documentation(info="<html>
<p>The paper's Eqs. (2) and (3), as a map: pick-offs read the pattern angle theta + e(theta), and a turning pattern shows it as
a scale factor that varies with theta, by -de/d theta. A gain mismatch g is e = -(g/4) sin 4 theta, a non-orthogonality d is
e = (d/4)(1 + cos 4 theta), an offset x0 is e = -(x0/2) sin 2 theta. Compensation of the output alone: loops and
forces use the angle as detected. The mean scale factor is corrected by the Bryan factor that the read-out believes.</p>
</html>"));
end ScaleFactorMap;
