"""Tests that separate the mechanisms from each other."""
