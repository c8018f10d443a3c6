"""What all of the navigator's side shares: Earth, attitude, states, statistics."""
