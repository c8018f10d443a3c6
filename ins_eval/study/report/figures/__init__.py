"""Drawings of the page."""
