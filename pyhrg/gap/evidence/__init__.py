"""Step 4: which effects explain the records, with probabilities."""
