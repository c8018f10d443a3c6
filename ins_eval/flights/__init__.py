"""The commands `hrg nav` and `hrg align`."""
