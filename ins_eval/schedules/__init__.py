"""Motions of a triad that are chosen by its gyros' maps."""
