"""What the gap between a simulated and a real gyro is worth to a navigator, in metres."""
