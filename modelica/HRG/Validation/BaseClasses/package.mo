within HRG.Validation;
package BaseClasses "What claims are made of"
end BaseClasses;
