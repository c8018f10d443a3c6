within HRG.Validation.Stiffness;
model ResidualQuadratureForce "Residual quadrature q: a constant quadrature force of q/tau"
  extends BaseClasses.Claim(
    redeclare type Quantity = Units.RelativeForce,
    gyro(controller(quadratureSetpoint = present*residual)));
  parameter Units.RelativeDisplacement residual = 1e-3 "q, over the amplitude";
equation
  measured = gyro.quadratureForce;
  expected = residual/tau;
  scale = residual/tau;
  annotation (experiment(StopTime = 20), Documentation(info="<html>
<p>N = q/tau: quadrature decays as amplitude does, and the loop keeps it up. Mechanism 8.</p>
</html>"));
end ResidualQuadratureForce;
