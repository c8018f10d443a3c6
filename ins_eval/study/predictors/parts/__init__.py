"""Calculations that several predictors use."""
