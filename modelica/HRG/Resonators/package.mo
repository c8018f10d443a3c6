within HRG;
package Resonators "The vibrating shell"
end Resonators;
