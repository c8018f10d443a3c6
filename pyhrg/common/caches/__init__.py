"""The user's cache: in a folder of the user alone, verified by digest before it is trusted."""
