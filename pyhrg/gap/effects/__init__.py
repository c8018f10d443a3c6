"""Step 3: what may make a gap, and what it does to the records."""
