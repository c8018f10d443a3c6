"""The page of a static record."""
