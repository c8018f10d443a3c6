"""Position error of a navigator that the gap between a simulated and a real gyro is worth."""
