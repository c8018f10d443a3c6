within HRG.Validation;
package Stiffness "Frequency split, quadrature, and stiffness that grows with amplitude"
end Stiffness;
