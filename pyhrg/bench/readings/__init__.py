"""What is read off a log: stretches at rest, turns, sweeps; data points and rows."""
