"""The virtual bench: one test procedure a file, each run on the gyro's FMU."""
