within HRG.Validation;
package Electronics "Errors of timing, of scale and of commanded rotation"
end Electronics;
