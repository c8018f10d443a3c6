"""A standing vehicle's record through the navigator, and how its errors go from step to step."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval import earth
from ins_eval.alignment import standing
from ins_eval.alignment.result import AlignmentError
from ins_eval.increments import Increments
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from ins_eval.sensor_errors import SensorErrors
from ins_eval.state import State, Track, position_error

Array = NDArray[np.float64]

STEP = 1.0
"""Time between measurements, s."""
MOST_STEPS = 300
"""More than so many measurements are not taken: the steps lengthen."""
FEWEST_STEPS = 15


@dataclass(frozen=True)
class Reckoning:
    """From one start attitude, velocity 0.

    displacement: (m, 2) computed, north, east, m; transition: (m, 13, 13) of `standing`'s errors;
    position: (3,) of the vehicle; interval: of the increments, s; step: s.
    """

    track: Track
    displacement: Array
    transition: Array
    position: Array
    interval: float
    step: float

    def noise(self, errors: SensorErrors) -> Array:
        """(13, 13) covariance that each step adds."""
        latitude, height = float(self.position[0]), float(self.position[2])
        drive = standing.noise(errors, self.interval, float(earth.gravity(latitude, height)))
        return standing.discretised(standing.dynamics(latitude, height), drive, self.step)[1]

    def first_error(self, last: Array) -> Array:
        """States' errors (13,) at the start that lead to those at the end."""
        whole = np.eye(standing.STATES)
        for transition in self.transition:
            whole = transition @ whole
        return np.asarray(np.linalg.solve(whole, last))


def in_whole_steps(record: Increments) -> tuple[Increments, int]:
    """The record's end in whole steps, and intervals a step.

    Raises:
        AlignmentError: too short a record.
    """
    wanted = max(STEP, record.duration / MOST_STEPS) / record.interval
    each = 2 * max(1, round(wanted / 2))
    count = len(record) // each
    if count < FEWEST_STEPS:
        raise AlignmentError(
            f"{record.duration:g} s of increments every {record.interval:g} s: "
            f"expected at least {FEWEST_STEPS * each * record.interval:g} s"
        )
    return record.between(len(record) - count * each, len(record)), each


def reckoned(record: Increments, position: Array, mat_nb: Array, each: int) -> Reckoning:
    """Dead reckoning from `mat_nb` (3, 3) at the start, kept every so many intervals.

    Raises:
        NavigationError: as `navigate`.
    """
    latitude, longitude, height = map(float, position)
    start = State(latitude, longitude, height, np.zeros(3), mat_nb)
    track = navigate(start, record, Clamped(np.full(len(record) + 1, height)), each)
    begun = np.concatenate([mat_nb[None], track.mat_nb[:-1]])
    step = each * record.interval
    still = np.zeros((standing.STATES, 1))
    transition, _ = standing.discretised(standing.dynamics(latitude, height), still, step)
    return Reckoning(
        track=track,
        displacement=position_error(track.position, np.asarray(position, dtype=float))[:, :2],
        transition=standing.in_body_axes(transition, 0.5 * (begun + track.mat_nb)),
        position=np.asarray(position, dtype=float),
        interval=record.interval,
        step=step,
    )


def corrected(mat_nb: Array, attitude: Array) -> Array:
    """Attitudes (..., 3, 3) less their estimated errors (..., 3), rad."""
    return np.asarray(Rotation.from_rotvec(-attitude).as_matrix() @ mat_nb)
