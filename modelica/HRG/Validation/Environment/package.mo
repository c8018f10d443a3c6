within HRG.Validation;
package Environment "Temperature, bias voltage, vibration, specific force, mounting angle and age"
end Environment;
