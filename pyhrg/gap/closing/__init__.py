"""Step 8: the simulation with what was found, verified on held-out tests."""
