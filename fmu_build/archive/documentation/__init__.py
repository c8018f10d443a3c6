"""The archive's pages for people."""
