"""How much an error at any moment weighs in the final one: one pass backward."""

from dataclasses import dataclass

import numpy as np
import xarray as xr
from numpy.typing import NDArray

from ins_eval.error_model.linear_model import AXES, LinearModel
from ins_eval.error_model.states import COUNT, NAMES, UNITS

Array = NDArray[np.float64]

COMPONENTS = ("north", "east")
HORIZONTAL = np.eye(COUNT)[:2]
"""(2, 10) the states that make the final position error, north and east."""

BODY = ("forward", "right", "down")
SENSORS = tuple(f"{kind} {axis}" for kind in ("gyro", "accelerometer") for axis in BODY)


@dataclass(frozen=True)
class Weights:
    """Final error, north and east, per error before; m.

    model: whose errors these are; states: (n + 1, 2, 10) per error of each state at the bounds of
    the steps; sensors: (n, 2, 6) per rad (gyros) and m/s (accelerometers) that a sensor errs by
    in a step, as `Increments` count them: that is m per rad/s and second, mean over the step.
    """

    model: LinearModel
    states: Array
    sensors: Array

    @property
    def step_coefficients(self) -> Array:
        """(n, 2, e, 3) per coefficient of each effect and axis that holds during one step."""
        return np.asarray(np.einsum("nij,njea->niea", self.states[1:], self.model.inputs))

    @property
    def coefficients(self) -> Array:
        """(2, e, 3) per coefficient that holds all the time."""
        return np.asarray(self.step_coefficients.sum(axis=0))


def weights(model: LinearModel) -> Weights:
    """Weights in the last moment's position error (Bryson and Ho 1975, section 2.7; adjoint method
    in Zarchan 2012, chapter 4)."""
    states = np.empty((len(model) + 1, len(HORIZONTAL), COUNT))
    states[-1] = HORIZONTAL
    for k in range(len(model) - 1, -1, -1):
        states[k] = states[k + 1] @ model.transition[k]
    return Weights(model, states, states[1:] @ model.constant_errors / model.step)


def labelled(found: Weights) -> xr.Dataset:
    """Weights with names, times and units."""
    time = found.model.time
    middle = 0.5 * (time[1:] + time[:-1])
    effects = found.model.effects
    gyro, accelerometer = found.sensors[..., :AXES], found.sensors[..., AXES:]
    axes = ("time", "component", "axis")
    return xr.Dataset(
        {
            "gyro": (axes, gyro, {"units": "m/rad", "long_name": "final error per gyro's error"}),
            "accelerometer": (
                axes,
                accelerometer,
                {"units": "s", "long_name": "final error per accelerometer's error"},
            ),
            "state_weight": (
                ("bound", "component", "state"),
                found.states,
                {"units": "m per state_unit"},
            ),
            "coefficient": (
                ("component", "effect", "axis"),
                found.coefficients,
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
