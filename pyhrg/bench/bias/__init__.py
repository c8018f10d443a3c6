"""Bias: at a position, over the circumference, temperature, specific force, vibration, years."""
