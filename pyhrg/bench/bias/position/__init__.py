"""Bias over the pattern's positions: fixed position and full circumference."""
