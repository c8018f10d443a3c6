within HRG.Validation;
package Damping "Damping anisotropy of shell and mounting, and ring-down, which shows it without a drive"
end Damping;
