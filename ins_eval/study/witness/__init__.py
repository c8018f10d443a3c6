"""Gyros of a study whose own channels are read in flight (docs/methods/witness.md)."""
