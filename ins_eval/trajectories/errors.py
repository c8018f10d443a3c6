"""What goes wrong with trajectories."""


class TrajectoryError(Exception):
    """No trajectory comes of it; the message says where, what was found, and what expected."""
