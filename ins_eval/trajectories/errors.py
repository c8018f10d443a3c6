"""What goes wrong with trajectories."""


class TrajectoryError(Exception):
    """No trajectory comes of it; the message says where, what was found, and what expected."""


class MovingStartError(TrajectoryError):
    """A mission that starts in motion is to stand still first."""
