"""What the navigator's side shares: Earth, attitude, states, compiled loops."""
