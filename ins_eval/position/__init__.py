"""The gap between a simulated and a real gyro as a position error of a navigator."""
