"""Second-order error of an alignment at rest (docs/methods/mission_model.md, Eqs. 7 and 8).

The heading error of gyrocompassing is the east gyro's error over the measured level rate of the
Earth. The north gyro's error changes that rate: 0.1 deg/h is 1 % of it at 47 deg of latitude. Where
the heading error dominates a mission, this is most of what a linear model misses. Flights therefore
use the attitude error that the alignment makes without linearisation.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ins_eval.alignment.analytic import attitude_at_rest, bias_sensitivity
from ins_eval.common import earth
from pyhrg.common.arrays import Array


@dataclass(frozen=True)
class AlignmentAtRest:
    """The alignment of a vehicle at rest, and what its attitude error does later.

    Attributes:
        latitude: rad.
        height: m.
        mat_nb: (3, 3) true attitude.
        rates: (COUNT, 3) mean rate error over the alignment per coefficient of
            `MissionWeights.maps`.
        attitude: (k, 2, 3) later position error, m, per rad of attitude error after the alignment.
    """

    latitude: float
    height: float
    mat_nb: Array
    rates: Array
    attitude: Array


def compute_second_order_error(alignment: AlignmentAtRest, rate: Array, force: Array) -> Array:
    """(r, k, 2) position error, m, that the linear model of the alignment misses (Eq. 8).

    rate: (r, 3) mean rate error over the alignment, rad/s, body axes; force: (r, 3) mean
    specific-force error, m/s^2, body axes.
    """
    gravity = earth.gravity(alignment.latitude, alignment.height)
    by_rate, by_force = np.hsplit(bias_sensitivity(alignment.latitude, gravity), 2)
    linear = rate @ (by_rate @ alignment.mat_nb).T + force @ (by_force @ alignment.mat_nb).T
    missed = compute_attitude_error(alignment, rate, force) - linear
    return np.asarray(np.einsum("kia,ra->rki", alignment.attitude, missed))


def compute_attitude_error(alignment: AlignmentAtRest, rate: Array, force: Array) -> Array:
    """(r, 3) attitude error after the alignment, rad, north, east, down (Eq. 7); arguments as
    above."""
    level = np.array([np.cos(alignment.latitude), 0.0, -np.sin(alignment.latitude)])
    true_rate = earth.RATE * level @ alignment.mat_nb
    gravity = float(earth.gravity(alignment.latitude, alignment.height))
    true_force = np.array([0.0, 0.0, -gravity]) @ alignment.mat_nb
    mat_nb = attitude_at_rest(true_rate + rate, true_force + force)
    return np.asarray(Rotation.from_matrix(mat_nb @ alignment.mat_nb.T).as_rotvec())
