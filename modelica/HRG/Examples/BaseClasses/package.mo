within HRG.Examples;
package BaseClasses "What examples share"
end BaseClasses;
