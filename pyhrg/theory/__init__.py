"""Closed forms that tests hold the FMU to."""
