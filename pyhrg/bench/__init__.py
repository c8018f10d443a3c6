"""The test bench: procedures that record on the simulated gyro and evaluate records of any gyro."""
