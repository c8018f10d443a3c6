within HRG.Validation;
package Precession "Where the pattern goes: locked, free or turned"
end Precession;
