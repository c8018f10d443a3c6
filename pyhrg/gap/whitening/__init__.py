"""Step 3: the noise of each channel, and the filter that makes it white."""
