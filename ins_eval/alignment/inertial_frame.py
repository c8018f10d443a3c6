"""Coarse alignment: attitude from the rotation of gravity in inertial space; the vehicle may sway.

The gyros refer the specific force to the first body axes, fixed in inertial space. It is integrated
over spans, in which a swaying vehicle contributes only the change of a bounded velocity. The
remaining part is gravity, which Earth's rotation turns about the pole (Silson 2011; Wahba 1965).
docs/methods/alignment.md, Eq. 4.
"""

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from ins_eval.common import earth
from ins_eval.navigation.algebra import (
    add,
    add_quaternions,
    multiply,
    quaternion_minus_identity,
    rotate,
)
from ins_eval.navigation.body_step import integrate_body_step
from ins_eval.navigation.coefficients import StepCoefficients, derive_coefficients
from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop
from pyhrg.common.errors import HrgError
from pyhrg.records.imu.log import Increments

SPANS = 20
"""Number of spans of a record. Chosen."""
SAMPLES = 2
"""Increments a navigation step. Chosen."""


@dataclass(frozen=True)
class InertialFrameFit:
    """The rotation between two frames that are fixed in inertial space.

    Attributes:
        mat_ib: (3, 3) from the first body axes to the first navigation axes.
        gravity: (k, 3) mean directions of the upward reaction to gravity in the first navigation
            axes.
        misfit: (k, 3) of the measured directions, rad.
        span: duration, s.
    """

    mat_ib: Array
    gravity: Array
    misfit: Array
    span: float


def estimate_sway_velocity(fit: InertialFrameFit, gravity: float) -> float:
    """Estimate the standard deviation of the velocity at the spans' ends from the misfit, m/s.

    The degrees of freedom are two a span less the three of the fitted rotation; a difference of two
    velocities has twice the variance.
    """
    freedom = 2 * (2 * len(fit.gravity) - 3)
    return float(np.sqrt(np.sum(fit.misfit**2) / freedom) * gravity * fit.span)


def fit_inertial_frame(record: Increments, position: Array) -> InertialFrameFit:
    """Solve Wahba's problem for the velocity changes of the spans."""
    steps = len(record) // (SAMPLES * SPANS)
    if steps < 1:
        raise HrgError(f"{len(record)} increments: expected at least {SPANS * SAMPLES}")
    used = record.between(len(record) - steps * SAMPLES * SPANS, len(record))
    gained = np.empty((SPANS, 3))
    integrate_in_inertial_frame(
        used.rotation, used.velocity, derive_coefficients(SAMPLES), steps, gained
    )
    measured = gained / np.linalg.norm(gained, axis=1, keepdims=True)
    span = steps * SAMPLES * record.interval
    gravity = gravity_in_inertial_frame(float(position[0]), span)
    turned, _ = Rotation.align_vectors(gravity, measured)
    return InertialFrameFit(
        mat_ib=turned.as_matrix(),
        gravity=gravity,
        misfit=turned.apply(measured) - gravity,
        span=span,
    )


def gravity_in_inertial_frame(latitude: float, span: float) -> Array:
    """Return the directions (SPANS, 3) of the mean upward reaction in the first navigation axes."""
    middle = span * (np.arange(SPANS) + 0.5)
    axis = earth.rotation_rate(latitude) / earth.RATE
    up = np.array([0.0, 0.0, -1.0])
    along = (up @ axis) * axis
    across = (up - along) * np.sinc(earth.RATE * span / 2 / np.pi)
    turned = Rotation.from_rotvec(np.outer(middle, earth.rotation_rate(latitude))).apply(
        along + across
    )
    return np.asarray(turned / np.linalg.norm(turned, axis=1, keepdims=True))


@compile_loop
def integrate_in_inertial_frame(
    rotation: Array, velocity: Array, coefficients: StepCoefficients, keep: int, out: Array
) -> None:
    """Integrate the specific force in the first body axes, which stay fixed in inertial space;
    `out` (SPANS, 3) takes the velocity change of each span of `keep` steps."""
    n = len(coefficients.mean)
    q = (1.0, 0.0, 0.0, 0.0)
    gained = (0.0, 0.0, 0.0)
    for k in range(len(rotation) // n):
        turned, change, _ = integrate_body_step(rotation, velocity, k * n, coefficients)
        gained = add(gained, rotate(q, change))
        q = add_quaternions(q, multiply(q, quaternion_minus_identity(turned)))
        if (k + 1) % keep == 0:
            out[(k + 1) // keep - 1] = np.array(gained)
            gained = (0.0, 0.0, 0.0)
