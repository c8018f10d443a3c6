"""The subcommands of `hrg` that this package brings, one file each."""
