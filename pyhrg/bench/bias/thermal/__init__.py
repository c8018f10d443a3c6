"""Bias and scale factor over temperature."""
