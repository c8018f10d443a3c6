"""One vehicle's mission: power-on and alignment at rest, then dead reckoning, compared with the
truth.

Five minutes pass from power-on to the end of alignment (paper, 2.3), the gyros' start-up included.
Alignment uses the record from the moment at which the last gyro is ready.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.common.rotation import euler_from_mat
from ins_eval.mission_model.missions import STILL
from ins_eval.study.cosimulated import (
    MissionTruth,
    align_and_navigate,
    align_at_rest,
    sample_trajectory,
)
from ins_eval.trajectories.trajectory import Trajectory
from pyhrg.common.arrays import Array, Mask
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

INTERVAL = 0.01
"""Duration of the IMU's increments, s."""
KEPT = 60.0
"""Time between kept positions, s."""


@dataclass(frozen=True)
class Mission:
    """A motion that every triad flies through. time: (m,) of kept positions, s; truth: of it, from
    power-on."""

    name: str
    time: Array
    truth: MissionTruth

    def heading_error(self, measured: Increments, ready: float = -STILL) -> float:
        """Heading error of the alignment on increments over the intervals of the truth, clockwise,
        rad; all gyros are ready from time `ready`, s, on."""
        aligned = align_at_rest(self.truth, measured, ready + STILL)
        heading, true = (
            euler_from_mat(mat)[2]
            for mat in (aligned, align_at_rest(self.truth, self.truth.increments, 0.0))
        )
        return float(np.remainder(heading - true + np.pi, 2 * np.pi) - np.pi)

    def fly(self, measured: Increments, ready: float = -STILL) -> Array:
        """(m, 2) north and east position error at the times `time`, m, of a navigator that aligns
        itself; arguments as for `heading_error`."""
        return align_and_navigate(self.truth, measured, ready + STILL)


def find_ready_time(good: Mask | None) -> float:
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
    truth = sample_trajectory(trajectory, 60.0 * minutes, KEPT, INTERVAL)
    return Mission(trajectory.name, KEPT * np.arange(1.0, minutes + 1), truth)
