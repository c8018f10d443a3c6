"""Tests of the scale factor over the circumference and over the rate."""
