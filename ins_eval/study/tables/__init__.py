"""The formats of a study's table and scores."""
