"""The sealed truth of each case: effects of the catalogue, or an error that it lacks."""
