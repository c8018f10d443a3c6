within HRG.Validation;
package RandomErrors "Noise, by its Allan deviation"
end RandomErrors;
