within HRG.Validation;
package PickOffs "Errors of pick-offs, demodulation and converter"
end PickOffs;
