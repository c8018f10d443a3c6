"""Step 5: which effects explain the records, with probabilities."""
