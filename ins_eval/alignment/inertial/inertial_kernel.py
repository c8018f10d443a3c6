"""Integration of the specific force in the inertial frame, compiled."""

import numpy as np

from ins_eval.common.compiled import compile_loop
from ins_eval.navigation.algebra import (
    add,
    add_quaternions,
    multiply,
    quaternion_minus_identity,
    rotate,
)
from ins_eval.navigation.body_step import integrate_body_step


@compile_loop
def integrate_in_inertial_frame(rotation, velocity, coefficients, keep, out):
    """Integrate the specific force in the first body axes, which stay fixed in inertial space.

    Args:
        rotation, velocity: (n, 3) increments; coefficients: `StepCoefficients`.
        keep: steps a span.
        out: (spans, 3) takes the velocity change of each span.

    Returns:
        Quaternion from the last body axes to the first.
    """
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
    return q
