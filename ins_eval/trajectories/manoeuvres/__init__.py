"""What a vehicle can do, one kind a file."""
