"""Readings of a log: stretches at rest, turns and sweeps; data points and rows."""
