"""Estimates the drift of a gyro's bias map from its own channels (docs/methods/witness.md)."""
