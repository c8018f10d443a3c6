"""Lock-in, its compensation and its cancellation."""
