"""Which noise of the output angle goes beyond the believed one."""
