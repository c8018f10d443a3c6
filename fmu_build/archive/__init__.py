"""Content of the archive beside the binaries."""
