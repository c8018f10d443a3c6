"""What is wrong with each gyro of a challenge, sealed."""
