"""Bayesian comparison of the noise terms of one channel."""
