"""Parts that all of the navigator's side uses: Earth, attitude, states, statistics."""
