"""A vehicle's motion: truth, and what an ideal IMU feels on it."""
