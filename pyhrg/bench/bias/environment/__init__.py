"""Bias under acceleration, vibration and shock."""
