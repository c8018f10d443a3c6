"""What the archive holds beside the binaries."""
