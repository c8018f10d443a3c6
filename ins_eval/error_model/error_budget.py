"""Error budgets of the final position error, of sensor errors that are known and of their 1-sigma,
by the adjoint: one pass backward in time gives the weights of all errors.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
import pandas as pd
import xarray as xr
from scipy.signal import lfilter

from ins_eval.error_model.decomposition import sum_over_steps
from ins_eval.error_model.dynamics import COUNT, NAMES
from ins_eval.error_model.linear_model import LinearModel
from pyhrg.common.arrays import Array
from pyhrg.records.imu.log import Increments

COMPONENTS = ("north", "east")
HORIZONTAL = np.eye(COUNT)[:2]
"""(2, 10) matrix that takes the position errors north and east from the state."""

BODY = ("forward", "right", "down")
SENSORS = tuple(f"{kind} {axis}" for kind in ("gyro", "accelerometer") for axis in BODY)


@dataclass(frozen=True)
class Weights:
    """Final position error, north and east, m, per earlier error.

    Attributes:
        model: the linear model.
        states: (n + 1, 2, 10) weight of an error of each state at the bounds of the steps.
        sensors: (n, 2, 6) weight of an error in one step, of each gyro's increment, rad, and of
            each accelerometer's, m/s.
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


def separate_keys(effect: str) -> tuple[str, str]:
    """Name of an effect, and the keys that state it: in brackets behind the name, if there are
    any."""
    name, _, keys = effect.removesuffix(")").partition(" (")
    return name, keys


def sum_contributions(budget: xr.Dataset) -> Array:
    """Return the sum (2,) of all contributions: the final error north and east, m."""
    return np.asarray(
        budget.contribution.sum(("effect", "axis", "time")) + budget.initial.sum("state")
    )


COLUMNS = ("effect", "axis", "north_sigma_m", "east_sigma_m")
INITIAL, NOISE = "rest of the alignment error", "random walks"


def compute_sigma_budget(weights: Weights, initial: Array, sigmas: Array) -> pd.DataFrame:
    """Standard deviation of the final position by effect and axis, m; the squares sum to the
    covariance's (docs/methods/error_model.md, Eq. 12a).

    initial: (10, 10) covariance at the beginning; sigmas: (e, 3) of the coefficients.
    """
    model = weights.model
    each = np.einsum("nij,njea->neai", weights.states[1:], model.inputs)
    persistence = model.persistence
    families: dict[tuple[str, str], Array] = {}
    for number, effect in enumerate(model.effects):
        for axis, name in enumerate(BODY):
            part = each[:, number, axis]
            summed = lfilter([1.0], [1.0, -persistence[number]], part, axis=0)
            variance = sigmas[number, axis] ** 2 * np.sum(part * (2 * summed - part), axis=0)
            key = (effect.family, name)
            families[key] = families.get(key, np.zeros(2)) + variance
    last = weights.states[1:]
    noise = np.einsum("nij,njk,nik->i", last, model.noise_covariance, last)
    start = np.einsum("ij,jk,ik->i", weights.states[0], initial, weights.states[0])
    return _tabulate({**families, (NOISE, ""): noise, (INITIAL, ""): start})


def _tabulate(variances: Mapping[tuple[str, str], Array]) -> pd.DataFrame:
    rows = [
        (*name, *np.sqrt(variance).tolist())
        for name, variance in variances.items()
        if np.any(variance > 0)
    ]
    return pd.DataFrame(rows, columns=list(COLUMNS))
