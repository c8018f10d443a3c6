"""The phase diagram: map over noise against turning, and where each bench test tells the truth."""
