"""Scale factor over the circumference and over the rate."""
