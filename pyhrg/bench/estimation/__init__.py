"""Estimates with honest intervals, whatever the test."""
