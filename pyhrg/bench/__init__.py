"""The test bench: procedures that make records on the simulated gyro and evaluate records of any
gyro."""
