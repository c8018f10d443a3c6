"""A mission, gyros, accelerometers and navigator as one archive of the SSP standard."""
