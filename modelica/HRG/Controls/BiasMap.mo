within HRG.Controls;
block BiasMap "Bias against pattern angle as calibrated, and its integral to take out of the output"
  parameter Units.Time samplePeriod "Control period";
  Boolean tick = sample(0, samplePeriod) "Each control period";
  parameter Units.AngularVelocity mean(min = -1, max = 1) = 0 "Mean over the circumference, typically up to 0.2 deg/h" annotation(Evaluate = false);
  parameter Units.AngularVelocity cos2(min = -1, max = 1) = 0 "Coefficient of cos 2 theta, typically up to 0.1 deg/h" annotation(Evaluate = false);
  parameter Units.AngularVelocity sin2(min = -1, max = 1) = 0 "Coefficient of sin 2 theta, typically up to 0.1 deg/h" annotation(Evaluate = false);
  parameter Units.AngularVelocity cos4(min = -1, max = 1) = 0 "Coefficient of cos 4 theta, typically 0.4 to 8 deg/h with damping left as it is" annotation(Evaluate = false);
  parameter Units.AngularVelocity sin4(min = -1, max = 1) = 0 "Coefficient of sin 4 theta, typically 0.4 to 8 deg/h with damping left as it is" annotation(Evaluate = false);
  parameter Units.AngularVelocity cos8(min = -1, max = 1) = 0 "Coefficient of cos 8 theta, typically up to 0.3 deg/h" annotation(Evaluate = false);
  parameter Units.AngularVelocity sin8(min = -1, max = 1) = 0 "Coefficient of sin 8 theta, typically up to 0.3 deg/h" annotation(Evaluate = false);
  input Units.DimensionlessRatio cosine "Of the modal angle 2 theta";
  input Units.DimensionlessRatio sine "Of the modal angle 2 theta";
  discrete output Units.Angle correction(start = 0, fixed = true) "Integral of the bias since power-on";
protected
  discrete Units.AngularVelocity bias(start = 0, fixed = true) "Bias at the present pattern angle";
  discrete Units.DimensionlessRatio c4(start = 1, fixed = true) "cos 4 theta";
  discrete Units.DimensionlessRatio s4(start = 0, fixed = true) "sin 4 theta";
equation
  when tick then
    c4 = cosine*cosine - sine*sine;
    s4 = 2*cosine*sine;
    correction = pre(correction) + samplePeriod*pre(bias);
    bias = mean + cos2*cosine + sin2*sine + cos4*c4 + sin4*s4 + cos8*(c4*c4 - s4*s4) + sin8*2*c4*s4;
  end when;
  annotation (Documentation(info="<html>
<p>The paper's Eq. (5), as a map: in the dead zone the pattern stands still where its bias balances the input, and
the bias at that angle is the input. Compensation of the output alone; the pattern goes its way.</p>
</html>"));
end BiasMap;
