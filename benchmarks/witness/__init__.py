"""How much of the drift of a gyro's map its own channels tell (docs/methods/witness.md)."""
