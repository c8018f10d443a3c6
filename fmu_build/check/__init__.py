"""`hrg check`: checks an FMU of any maker by our own rules and by other people's tools."""
