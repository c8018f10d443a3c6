"""Step 4: what may cause a gap, and its effect on the records."""
