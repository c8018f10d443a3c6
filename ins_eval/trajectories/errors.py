"""What goes wrong with trajectories."""

from pyhrg.common.errors import HrgError


class TrajectoryError(HrgError):
    """No trajectory comes of it; the message says where, what was found, and what expected."""


class MovingStartError(TrajectoryError):
    """A mission that starts in motion is to stand still first."""
