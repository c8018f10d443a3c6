"""The campaigns of a challenge: nominal device, plans of the tests, instruments, the true gyro."""
