"""Tests of the gyro's noise."""
