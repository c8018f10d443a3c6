"""One vehicle's flight: alignment at rest, then dead reckoning, against the truth."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import static_alignment
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.state import State, position_error
from ins_eval.trajectories.trajectory import Trajectory

Array = NDArray[np.float64]

INTERVAL = 0.01
"""Of the IMU's increments, s."""
WARM_UP = 20.0
"""Time from power-on to the beginning of alignment, s."""
ALIGNMENT = 300.0
"""Duration of static alignment, s; it ends at time 0, where navigation begins."""
STILL = WARM_UP + ALIGNMENT
KEPT = 60.0
"""Time between kept positions, s."""


@dataclass(frozen=True)
class Mission:
    """The truth that every triad flies through."""

    name: str
    truth: Increments
    """From power-on at -STILL."""
    time: Array
    """(m,) of kept positions, s."""
    position: Array
    """(m, 3) true latitude, longitude, height at those times."""
    height: Array
    """(n + 1,) reference height for the navigator's clamp, m."""
    start: Array
    """(3,) position at time 0."""

    def fly(self, measured: Increments) -> Array:
        """Align and navigate on measured increments.

        Args:
            measured: over the same intervals as `truth`.

        Returns:
            (m, 2) north and east position error at the times `time`, m.
        """
        first, zero = round(WARM_UP / INTERVAL), round(STILL / INTERVAL)
        mat_nb = static_alignment(measured.between(first, zero), float(self.start[0]))
        latitude, longitude, height = map(float, self.start)
        state = State(latitude, longitude, height, np.zeros(3), mat_nb)
        flight = measured.between(zero, len(measured))
        track = navigate(state, flight, Clamped(self.height), round(KEPT / INTERVAL))
        return position_error(track.position, self.position)[:, :2]


def mission(trajectory: Trajectory, hours: float) -> Mission:
    """The truth along a trajectory that stands still from -STILL to 0, for whole minutes."""
    minutes = round(hours * 60)
    flight = minutes * round(KEPT / INTERVAL)
    time = KEPT * np.arange(1.0, minutes + 1)
    steps = INTERVAL * np.arange(flight + 1.0)
    return Mission(
        name=trajectory.name,
        truth=trajectory.increments(-STILL, INTERVAL, flight + round(STILL / INTERVAL)),
        time=time,
        position=trajectory.position(time),
        height=trajectory.position(steps)[:, 2],
        start=trajectory.position(np.array(0.0)),
    )
