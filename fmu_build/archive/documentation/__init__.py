"""Pages of the archive for people to read."""
