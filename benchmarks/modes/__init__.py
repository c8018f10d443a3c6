"""What modes of operation buy, on the bench and in metres (docs/modes.md)."""
