"""Alignment at rest beyond first order.

The heading that gyrocompassing finds errs by the east gyro's error over Earth's level rate, which
the north gyro's error changes by its share of it: 0.1 deg/h is 1 % at 47 deg of latitude. In a
mission that lives on its alignment this is most of what a linear model misses, so that flights use
the attitude error that the alignment makes.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from ins_eval.alignment.analytic import attitude_at_rest
from ins_eval.common import earth
from ins_eval.error_model.aligning import attitude_error

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Standing:
    """A vehicle at rest. latitude: rad; height: m; mat_nb: (3, 3);
    rates: (COUNT, 3) mean rate error over the alignment per coefficient of `MissionWeights.maps`;
    attitude: (k, 2, 3) later position error, m, per attitude error at its end.
    """

    latitude: float
    height: float
    mat_nb: Array
    rates: Array
    attitude: Array


def beyond_first_order(standing: Standing, rate: Array, force: Array) -> Array:
    """(r, k, 2) m that the alignment's attitude error adds to the linear model's.

    Args:
        standing: where.
        rate: (r, 3) mean rate error over the alignment, rad/s, body axes.
        force: (r, 3) mean specific-force error, m/s^2, body axes.
    """
    by_rate, by_force = attitude_error(np.array(standing.latitude), np.array(standing.height))
    linear = rate @ (by_rate @ standing.mat_nb).T + force @ (by_force @ standing.mat_nb).T
    beyond = attitude_made(standing, rate, force) - linear
    return np.asarray(np.einsum("kia,ra->rki", standing.attitude, beyond))


def attitude_made(standing: Standing, rate: Array, force: Array) -> Array:
    """(r, 3) attitude error of the alignment, rad, north, east, down; arguments as above."""
    level = np.array([np.cos(standing.latitude), 0.0, -np.sin(standing.latitude)])
    true_rate = earth.RATE * level @ standing.mat_nb
    gravity = float(earth.gravity(standing.latitude, standing.height))
    true_force = np.array([0.0, 0.0, -gravity]) @ standing.mat_nb
    found = attitude_at_rest(true_rate + rate, true_force + force)
    return np.asarray(Rotation.from_matrix(found @ standing.mat_nb.T).as_rotvec())
