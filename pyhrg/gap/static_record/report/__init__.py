"""The files of a diagnosis of a static record."""
