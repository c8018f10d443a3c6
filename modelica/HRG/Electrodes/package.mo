within HRG;
package Electrodes "Between shell and electronics: pick-offs and drives"
end Electrodes;
