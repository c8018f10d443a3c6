"""Static alignment as steps of the linear model.

Pitch and roll follow from the mean specific force and heading from the mean rate
(`alignment.analytic`), so that each moment's error of the sensors adds its share to the attitude.
Joined before the model of the navigation, errors during alignment weigh in the final error too: a
bias that alignment hides cancels until the vehicle turns.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from ins_eval.common import earth
from ins_eval.common.sensor_errors import SensorErrors
from ins_eval.error_model.effects import BIASES, Effect
from ins_eval.error_model.linear_model import LinearModel, assembled
from ins_eval.error_model.motion import Motion
from ins_eval.error_model.states import ATTITUDE, COUNT

Array = NDArray[np.float64]


def alignment_model(
    still: Motion, effects: Sequence[Effect] = BIASES, noise: SensorErrors | None = None
) -> LinearModel:
    """Alignment over all of a motion at rest: starts from attitude error 0, and ends with the
    alignment's. Position and velocity errors, given from outside, stay as they are."""
    duration = still.step * len(still)
    g = np.zeros((len(still.mat_nb), COUNT, 6))
    by_rate, by_force = attitude_error(still.latitude, still.height)
    g[:, ATTITUDE, :3] = by_rate @ still.mat_nb / duration
    g[:, ATTITUDE, 3:] = by_force @ still.mat_nb / duration
    return assembled(still, np.zeros((len(still), COUNT, COUNT)), g, effects, noise)


def attitude_error(latitude: Array, height: Array) -> tuple[Array, Array]:
    """Attitude error (..., 3, 3), rad, by the mean rate's error, per rad/s, and by the mean
    specific force's, per m/s^2; north, east, down (Groves 2013, section 5.6.3)."""
    gravity = earth.gravity(latitude, height)
    by_rate, by_force = np.zeros((2, *np.shape(latitude), 3, 3))
    by_rate[..., 2, 1] = -1 / (earth.RATE * np.cos(latitude))
    by_force[..., 0, 1] = -1 / gravity
    by_force[..., 1, 0] = 1 / gravity
    by_force[..., 2, 1] = np.tan(latitude) / gravity
    return by_rate, by_force
