"""Diagnoses against truths."""
