"""Runs a study in blocks on Dask workers; each finished block is kept and not computed again."""
