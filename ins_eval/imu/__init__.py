"""Inertial measurement units, simulated and recorded."""
