"""Campaigns whose gap is hidden from the diagnosis, and what the diagnoses score."""
