"""Manoeuvres and overlays, one kind a file."""
