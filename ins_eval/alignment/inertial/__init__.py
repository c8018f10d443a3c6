"""Alignment in the inertial frame."""
