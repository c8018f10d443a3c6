"""The FMU that plays a trajectory from a file."""
