within HRG;
package Controls "Sampled control electronics"
end Controls;
