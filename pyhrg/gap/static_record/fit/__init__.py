"""Which noise terms explain a static record."""
