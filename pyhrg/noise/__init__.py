"""Noise of a gyro: Allan deviation, coefficients and their likelihood."""
