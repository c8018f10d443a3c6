"""What the options of `hrg nav` and `hrg align` mean."""
