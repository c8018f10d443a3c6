"""Predictors of the position error from bench figures, from simple to best.

Method: docs/methods/study_predictors.md, whose equations the modules cite.
"""
