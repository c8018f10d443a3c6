within HRG;
package Gyroscopes "Complete gyros: the roots that are exported"
end Gyroscopes;
