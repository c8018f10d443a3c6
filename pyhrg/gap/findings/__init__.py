"""Step 5: what a diagnosis says."""
