"""Linear error model of the navigator."""
