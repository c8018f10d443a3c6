"""The gyros of a study: population, maker, bench, drift."""
