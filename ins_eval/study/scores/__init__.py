"""Scores of predictions, with intervals over triads (docs/methods/study_predictors.md)."""
