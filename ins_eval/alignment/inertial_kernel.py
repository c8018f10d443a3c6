"""Specific force seen in the inertial frame, compiled."""

import numpy as np

from ins_eval.compiled import compiled
from ins_eval.navigation.kernel import add, multiply, quaternion, rotate, summed


@compiled
def integrate(rotation, velocity, weights, keep, out):
    """Integrates in the body axes of the start, frozen in inertial space.

    Args:
        rotation, velocity: (n, 3) increments; weights: `navigation.coefficients.Weights`.
        keep: steps between rows of `out`, which takes the velocity change since the row before.

    Returns:
        Quaternion from the last body axes to the first.
    """
    turning, scrolling, mean = weights
    n = len(mean)
    q = (1.0, 0.0, 0.0, 0.0)
    gained = (0.0, 0.0, 0.0)
    for k in range(len(rotation) // n):
        turned, change, _ = summed(rotation, velocity, k * n, turning, scrolling, mean)
        gained = add(gained, rotate(q, change))
        q = multiply(q, quaternion(turned))
        if (k + 1) % keep == 0:
            out[(k + 1) // keep - 1] = np.array(gained)
            gained = (0.0, 0.0, 0.0)
    return q
