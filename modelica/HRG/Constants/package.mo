within HRG;
package Constants "Mathematical constants"
  constant Real pi = 3.14159265358979323846 "Circle number";
end Constants;
