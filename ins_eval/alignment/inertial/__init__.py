"""Coarse alignment in the inertial frame."""
