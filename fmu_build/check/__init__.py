"""`hrg check`: what an FMU of any maker is held to; our own rules, and other people's tools."""
