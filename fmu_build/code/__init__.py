"""Equations to C."""
