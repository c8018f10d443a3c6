"""Bias tests: fixed position, circumference, temperature, specific force, vibration, ageing."""
