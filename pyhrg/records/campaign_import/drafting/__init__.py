"""A draft of a mapping: what the logs of a laboratory say of themselves."""
