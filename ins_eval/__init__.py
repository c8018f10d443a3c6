"""What the gyro does to a navigator."""
