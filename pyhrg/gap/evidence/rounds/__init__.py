"""The rounds of the search: a search among sets, a step of the gyro, a full simulation."""
