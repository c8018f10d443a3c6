"""The gyro as a user meets it: its parameters, its FMU, its theory and its test bench."""
