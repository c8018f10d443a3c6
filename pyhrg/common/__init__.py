"""Shared by all packages: units, errors, files, TOML tables, HTML pages, the command line."""
