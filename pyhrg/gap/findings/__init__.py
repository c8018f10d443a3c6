"""Step 6: what a diagnosis says."""
