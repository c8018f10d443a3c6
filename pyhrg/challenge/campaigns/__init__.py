"""The campaigns of a challenge: plans, instruments, the gyro that is recorded."""
