"""Estimators with 95 % intervals; they know no gyro and no log."""
