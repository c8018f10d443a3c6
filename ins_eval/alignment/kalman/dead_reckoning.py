"""Dead reckoning through a standing vehicle's record, with the transitions of its errors."""

from dataclasses import dataclass

import numpy as np
from filterpy.common import van_loan_discretization
from scipy.spatial.transform import Rotation

from ins_eval.alignment.kalman import aligning_model, standing
from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.common.state import State, Track, position_error
from ins_eval.navigation.height import Clamped
from ins_eval.navigation.strapdown import navigate
from pyhrg.common.arrays import Array
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

STEP = 2.0
"""Time between measurements, s. Chosen."""
MAX_STEPS = 300
"""Largest number of measurements; longer records have longer steps. Chosen."""
MIN_STEPS = 15
"""Smallest number of measurements. Chosen."""


@dataclass(frozen=True)
class Reckoning:
    """Navigation from one start attitude and velocity 0.

    Attributes:
        track: navigated states.
        displacement: (m, 2) navigated, north and east, m.
        turned: (m, 2) rotation about north and east since the start, rad.
        transition: (m, 30, 30) of the states of `aligning_model`.
        position: (3,) place of the vehicle: latitude, longitude (rad), height (m).
        interval: length of an increment, s.
        step: length of a navigation step, s.
    """

    track: Track
    displacement: Array
    turned: Array
    transition: Array
    position: Array
    interval: float
    step: float

    def noise(self, errors: SensorErrors) -> Array:
        """Return the covariance (30, 30) that noise adds in each step."""
        latitude, height = float(self.position[0]), float(self.position[2])
        gravity, duration = float(earth.gravity(latitude, height)), self.step * len(self.turned)
        return van_loan_discretization(
            aligning_model.dynamics(latitude, height, duration),
            aligning_model.noise(errors, self.interval, gravity, duration),
            self.step,
        )[1]

    def first_error(self, last: Array) -> Array:
        """Return the errors (13,) at the start that lead to those (30,) at the end, with constant
        biases."""
        core = aligning_model.CORE
        total = np.eye(standing.STATES)
        for transition in self.transition[:, core, core]:
            total = transition @ total
        return np.asarray(np.linalg.solve(total, last[core]))


def split_into_steps(record: Increments) -> tuple[Increments, int]:
    """Cut a record to whole steps, at its end; return it and the intervals a step."""
    wanted = max(STEP, record.duration / MAX_STEPS) / record.interval
    each = 2 * max(1, round(wanted / 2))
    count = len(record) // each
    if count < MIN_STEPS:
        raise HrgError(
            f"{record.duration:g} s of increments every {record.interval:g} s: "
            f"expected at least {MIN_STEPS * each * record.interval:g} s"
        )
    return record.between(len(record) - count * each, len(record)), each


def reckon(record: Increments, position: Array, mat_nb: Array, each: int) -> Reckoning:
    """Navigate from attitude `mat_nb` (3, 3); states are kept after every `each` intervals."""
    start = State.at_rest(position, mat_nb)
    track = navigate(start, record, Clamped(np.full(len(record) + 1, start.height)), each)
    before = np.concatenate([mat_nb[None], track.mat_nb[:-1]])
    step = each * record.interval
    dynamics = aligning_model.dynamics(start.latitude, start.height, step * len(before))
    transition, _ = van_loan_discretization(dynamics, np.zeros((len(dynamics), 1)), step)
    return Reckoning(
        track=track,
        displacement=position_error(track.position, np.asarray(position, dtype=float))[:, :2],
        turned=Rotation.from_matrix(track.mat_nb @ mat_nb.T).as_rotvec()[:, :2],
        transition=standing.put_biases_in_body_axes(transition, 0.5 * (before + track.mat_nb)),
        position=np.asarray(position, dtype=float),
        interval=record.interval,
        step=step,
    )


def correct_attitude(mat_nb: Array, attitude: Array) -> Array:
    """Return attitudes (..., 3, 3) less their estimated errors (..., 3), rad."""
    return np.asarray(Rotation.from_rotvec(-attitude).as_matrix() @ mat_nb)
