"""Alignment: initial attitude of a standing vehicle (docs/methods/alignment.md)."""
