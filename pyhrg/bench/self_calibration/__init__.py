"""Self-calibration by virtual rotation."""
