within HRG.Validation;
package Modes "Modes of operation and compensation"
end Modes;
