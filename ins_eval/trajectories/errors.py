"""Errors of trajectories, and the check of the durations that all of them share."""

import math

from pyhrg.common.errors import HrgError


class TrajectoryError(HrgError):
    """A trajectory can't be made; the message says where, what was found and what was expected."""


class MovingStartError(TrajectoryError):
    """A mission that starts in motion was asked to stand still first."""


def check_durations(name: str, duration: float, still: float) -> None:
    """Check the times, s, that a trajectory lasts and that it stands still before time 0."""
    if not (0 <= still < math.inf and 0 < duration < math.inf):
        raise TrajectoryError(
            f"{name}: found {still:g} s at rest and {duration:g} s after, expected 0 or "
            "more and above 0"
        )
