"""Fine alignment by a Kalman filter."""
