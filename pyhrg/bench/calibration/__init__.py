"""Calibration: maps are fitted and applied, and the calibration residual is measured."""
