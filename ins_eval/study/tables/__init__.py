"""Columns of a study's tables."""
