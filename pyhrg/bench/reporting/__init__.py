"""Outcomes as text, JSON and HTML; specification and parameter system."""
