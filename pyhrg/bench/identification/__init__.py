"""What tells the mechanisms apart."""
