"""Step 2: the noise of each channel, and filters that make it white."""
