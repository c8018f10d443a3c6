"""A standing vehicle's record through the navigator, and how its errors go from step to step."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.alignment.kalman import aligning_model, standing
from ins_eval.alignment.result import AlignmentError
from ins_eval.common import earth
from ins_eval.common.increments import Increments
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import State, Track, position_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate

Array = NDArray[np.float64]

STEP = 2.0
"""Time between measurements, s."""
MOST_STEPS = 300
"""More than so many measurements are not taken: the steps lengthen."""
FEWEST_STEPS = 15


@dataclass(frozen=True)
class Reckoning:
    """From one start attitude, velocity 0.

    displacement: (m, 2) computed, north, east, m; turned: (m, 2) rotation about north, east since
    the start, rad; transition: (m, 30, 30) of `aligning_model`'s errors; position: (3,) of the
    vehicle; interval: of the increments, s; step: s.
    """

    track: Track
    displacement: Array
    turned: Array
    transition: Array
    position: Array
    interval: float
    step: float

    def noise(self, errors: SensorErrors) -> Array:
        """(30, 30) covariance that each step adds."""
        latitude, height = float(self.position[0]), float(self.position[2])
        gravity, duration = float(earth.gravity(latitude, height)), self.step * len(self.turned)
        return standing.discretised(
            aligning_model.dynamics(latitude, height, duration),
            aligning_model.noise(errors, self.interval, gravity, duration),
            self.step,
        )[1]

    def first_error(self, last: Array) -> Array:
        """States' errors (13,) at the start that lead to those (30,) at the end, as if nothing
        wandered."""
        core = aligning_model.CORE
        whole = np.eye(standing.STATES)
        for transition in self.transition[:, core, core]:
            whole = transition @ whole
        return np.asarray(np.linalg.solve(whole, last[core]))


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
    dynamics = aligning_model.dynamics(latitude, height, step * len(begun))
    transition, _ = standing.discretised(dynamics, np.zeros((len(dynamics), 1)), step)
    return Reckoning(
        track=track,
        displacement=position_error(track.position, np.asarray(position, dtype=float))[:, :2],
        turned=Rotation.from_matrix(track.mat_nb @ mat_nb.T).as_rotvec()[:, :2],
        transition=standing.in_body_axes(transition, 0.5 * (begun + track.mat_nb)),
        position=np.asarray(position, dtype=float),
        interval=record.interval,
        step=step,
    )


def corrected(mat_nb: Array, attitude: Array) -> Array:
    """Attitudes (..., 3, 3) less their estimated errors (..., 3), rad."""
    return np.asarray(Rotation.from_rotvec(-attitude).as_matrix() @ mat_nb)
