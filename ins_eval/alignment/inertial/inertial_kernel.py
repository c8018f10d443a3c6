"""Specific force seen in the inertial frame, compiled."""

import numpy as np

from ins_eval.common.compiled import compiled
from ins_eval.navigation.algebra import add, multiply, quaternion_beyond_unity, rotate, sum4
from ins_eval.navigation.body_step import body_step


@compiled
def integrate(rotation, velocity, weights, keep, out):
    """Integrates in the body axes of the start, frozen in inertial space.

    Args:
        rotation, velocity: (n, 3) increments; weights: `navigation.coefficients.Weights`.
        keep: steps between rows of `out`, which takes the velocity change since the row before.

    Returns:
        Quaternion from the last body axes to the first.
    """
    n = len(weights.mean)
    q = (1.0, 0.0, 0.0, 0.0)
    gained = (0.0, 0.0, 0.0)
    for k in range(len(rotation) // n):
        turned, change, _ = body_step(rotation, velocity, k * n, weights)
        gained = add(gained, rotate(q, change))
        q = sum4(q, multiply(q, quaternion_beyond_unity(turned)))
        if (k + 1) % keep == 0:
            out[(k + 1) // keep - 1] = np.array(gained)
            gained = (0.0, 0.0, 0.0)
    return q
