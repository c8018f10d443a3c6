"""Weights of all errors in the final position error, by the adjoint: one pass backward in time."""

from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ins_eval.error_model.linear_model import AXES, LinearModel
from ins_eval.error_model.states import COUNT, NAMES, UNITS

Array = NDArray[np.float64]

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

    @property
    def step_coefficients(self) -> Array:
        """(n, 2, e, 3) weights of the coefficients of each effect and axis during one step."""
        return np.asarray(np.einsum("nij,njea->niea", self.states[1:], self.model.inputs))

    @property
    def coefficients(self) -> Array:
        """(2, e, 3) weights of constant coefficients of each effect and axis."""
        return np.asarray(self.step_coefficients.sum(axis=0))


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


def label_weights(weights: Weights) -> xr.Dataset:
    """Return weights as a dataset with names, times and units."""
    time = weights.model.time
    middle = 0.5 * (time[1:] + time[:-1])
    effects = weights.model.effects
    gyro, accelerometer = weights.sensors[..., :AXES], weights.sensors[..., AXES:]
    axes = ("time", "component", "axis")
    return xr.Dataset(
        {
            "gyro": (axes, gyro, {"units": "m/rad", "long_name": "final error per gyro error"}),
            "accelerometer": (
                axes,
                accelerometer,
                {"units": "s", "long_name": "final error per accelerometer error"},
            ),
            "state_weight": (
                ("bound", "component", "state"),
                weights.states,
                {"units": "m per state_unit"},
            ),
            "coefficient": (
                ("component", "effect", "axis"),
                weights.coefficients,
                {"units": "m per effect_unit", "long_name": "final error per constant coefficient"},
            ),
        },
        {
            "time": ("time", middle, {"units": "s", "long_name": "middle of the step"}),
            "bound": ("bound", time, {"units": "s"}),
            "component": list(COMPONENTS),
            "axis": list(BODY),
            "state": list(NAMES),
            "state_unit": ("state", list(UNITS)),
            "effect": [effect.name for effect in effects],
            "effect_unit": ("effect", [effect.unit for effect in effects]),
        },
    )
