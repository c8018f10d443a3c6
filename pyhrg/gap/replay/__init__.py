"""Step 1: the inputs of each log put to the simulated gyro, and the channels that are compared."""
