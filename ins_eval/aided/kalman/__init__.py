"""The error-state filter, its smoother, and the alignment in motion that they begin with."""
