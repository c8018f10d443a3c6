"""What a gyro's own channels tell of the drift of its bias map (docs/methods/witness.md)."""
