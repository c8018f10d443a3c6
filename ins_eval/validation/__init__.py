"""The experiment: which bench test predicts the navigator's error."""
