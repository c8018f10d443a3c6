"""Fine alignment by a Kalman filter on the displacement of a navigator."""
