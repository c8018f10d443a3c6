"""Random walk and its kin."""
