"""Which noise of the output angle goes beyond the stated one."""
