"""Running a study: in blocks that are spread by Dask, kept as they end, and never done twice."""
