"""The navigator's own error and speed, beside a peer's in the same run."""
