"""What all packages share: units, files, tables of TOML, pages, the command line."""
