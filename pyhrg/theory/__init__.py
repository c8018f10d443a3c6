"""Closed forms of a gyro's output: tests compare the FMU with them, predictions use them."""
