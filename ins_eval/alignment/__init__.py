"""Initial attitude."""
