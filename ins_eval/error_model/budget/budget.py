"""Error budgets of the final position error, of known sensor errors."""

from collections.abc import Mapping

import numpy as np
import xarray as xr

from ins_eval.error_model.budget.adjoint import COMPONENTS, SENSORS, Weights
from ins_eval.error_model.budget.decomposition import sum_over_steps
from ins_eval.error_model.states import NAMES
from pyhrg.common.arrays import Array
from pyhrg.records.imu.increments import Increments


def compute_budget(
    weights: Weights, signals: Mapping[str, Increments], initial: Array
) -> xr.Dataset:
    """Compute the contributions to the final position error, whose sum is the linear model's error
    (docs/methods/error_model.md, Eq. 12).

    Takes sensor errors (measured less true) by effect and the errors `initial` (10,) at the model's
    start. Returns `contribution` (effect, axis, time, component) and `initial` (state, component),
    m.
    """
    model = weights.model
    steps = {
        n: sum_over_steps(s, model.time[0], model.step, len(model)) for n, s in signals.items()
    }
    errors = np.stack([np.concatenate([s.rotation, s.velocity], axis=1) for s in steps.values()])
    contribution = np.einsum("nos,ens->esno", weights.sensors, errors)
    start = weights.states[0].T * initial[:, None]
    metres = {"units": "m"}
    return xr.Dataset(
        {
            "contribution": (("effect", "axis", "time", "component"), contribution, metres),
            "initial": (("state", "component"), start, metres),
        },
        {
            "effect": list(signals),
            "axis": list(SENSORS),
            "time": ("time", model.time[1:], {"units": "s", "long_name": "end of the step"}),
            "component": list(COMPONENTS),
            "state": list(NAMES),
        },
    )


def sum_contributions(budget: xr.Dataset) -> Array:
    """Return the sum (2,) of all contributions: the final error north and east, m."""
    return np.asarray(
        budget.contribution.sum(("effect", "axis", "time")) + budget.initial.sum("state")
    )
