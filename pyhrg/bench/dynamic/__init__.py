"""Range, threshold, start-up, bandwidth."""
