"""Motion of a vehicle: the truth that is flown, and the increments of an ideal IMU on it."""
