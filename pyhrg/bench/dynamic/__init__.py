"""Tests of measuring range, threshold, start-up and bandwidth."""
