"""The strapdown navigator."""
