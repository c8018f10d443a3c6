"""Step 1: the inputs of a log, put to the simulated gyro."""
