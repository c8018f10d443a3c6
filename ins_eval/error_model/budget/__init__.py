"""Error budgets: contributions to the final position error by effect, axis and time."""
