"""One vehicle's mission: power-on and alignment at rest, then dead reckoning, against the truth.

Five minutes from power-on to the end of alignment (paper, 2.3). The gyros' own start-up lies within
them: alignment uses the record from the moment on at which the last gyro is ready.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ins_eval.alignment.analytic import level_and_gyrocompass
from ins_eval.common.rotation import euler_from_mat
from ins_eval.common.state import State, position_error
from ins_eval.mission_model.missions import STILL
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

INTERVAL = 0.01
"""Duration of the IMU's increments, s."""
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

    @property
    def hours(self) -> float:
        """Duration from time 0 to the end."""
        return float(self.time[-1]) / 3600

    def align(self, measured: Increments, ready: float = -STILL) -> Array:
        """`mat_nb` (3, 3) at time 0, from increments over the intervals of `truth`; all gyros are
        ready from time `ready`, s, on."""
        first, zero = int(np.ceil((ready + STILL) / INTERVAL - 1e-6)), round(STILL / INTERVAL)
        return level_and_gyrocompass(measured.between(first, zero), float(self.start[0]))

    def heading_error(self, measured: Increments, ready: float = -STILL) -> float:
        """Heading error of the alignment, clockwise, rad; arguments as for `align`."""
        heading, true = (
            euler_from_mat(mat)[2] for mat in (self.align(measured, ready), self.align(self.truth))
        )
        return float(np.remainder(heading - true + np.pi, 2 * np.pi) - np.pi)

    def fly(self, measured: Increments, ready: float = -STILL) -> Array:
        """Align and navigate on measured increments; arguments as for `align`.

        Returns (m, 2) north and east position error at the times `time`, m.
        """
        state = State.at_rest(self.start, self.align(measured, ready))
        flight = measured.between(round(STILL / INTERVAL), len(measured))
        track = navigate(state, flight, Clamped(self.height), round(KEPT / INTERVAL))
        return position_error(track.position, self.position)[:, :2]


def find_ready_time(good: NDArray[np.bool_] | None) -> float:
    """Time from which on, until time 0, every interval of a record from power-on is good, s; None
    are good throughout."""
    if good is None:
        return -STILL
    rest = round(STILL / INTERVAL)
    first = int(np.max(np.flatnonzero(~good[:rest]), initial=-1)) + 1
    if first == rest:
        raise HrgError(f"gyros are not ready {STILL:g} s after power-on, when alignment ends")
    return first * INTERVAL - STILL


def sample_mission(trajectory: Trajectory, hours: float) -> Mission:
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
