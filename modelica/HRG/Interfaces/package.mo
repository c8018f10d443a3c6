within HRG;
package Interfaces "What a gyro shows to the outside"
end Interfaces;
