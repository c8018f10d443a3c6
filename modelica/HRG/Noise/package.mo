within HRG;
package Noise "Reproducible white noise"
end Noise;
