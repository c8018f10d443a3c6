"""Whose error it is: by effect, axis and time."""
