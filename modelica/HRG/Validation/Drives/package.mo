within HRG.Validation;
package Drives "Errors of drive electrodes"
end Drives;
