"""Weights of all errors in the final position error, by the adjoint: one pass backward in time."""

from dataclasses import dataclass

import numpy as np

from ins_eval.error_model.linear_model import LinearModel
from ins_eval.error_model.states import COUNT
from pyhrg.common.arrays import Array

COMPONENTS = ("north", "east")
HORIZONTAL = np.eye(COUNT)[:2]
"""(2, 10) matrix that takes the position errors north and east from the state."""

BODY = ("forward", "right", "down")
SENSORS = tuple(f"{kind} {axis}" for kind in ("gyro", "accelerometer") for axis in BODY)


@dataclass(frozen=True)
class Weights:
    """Final position error, north and east, m, per earlier error.

    model: the linear model; states: (n + 1, 2, 10) per error of each state at the bounds of the
    steps; sensors: (n, 2, 6) per error of a gyro's increment, rad, and of an accelerometer's, m/s,
    in one step.
    """

    model: LinearModel
    states: Array
    sensors: Array


def compute_weights(model: LinearModel) -> Weights:
    """Compute the weights in the position error at the model's end.

    docs/methods/error_model.md, Eqs. 11 and 12 (Bryson and Ho 1975, section 2.7; Zarchan 2012,
    chapter 4).
    """
    states = np.empty((len(model) + 1, len(HORIZONTAL), COUNT))
    states[-1] = HORIZONTAL
    for k in range(len(model) - 1, -1, -1):
        states[k] = states[k + 1] @ model.transition[k]
    return Weights(model, states, states[1:] @ model.constant_errors / model.step)
