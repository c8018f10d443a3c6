"""Budget of the final position's 1-sigma, where the sensors' errors themselves are not known."""

from collections.abc import Mapping

import numpy as np
import pandas as pd
from scipy.signal import lfilter

from ins_eval.error_model.budget.adjoint import BODY, Weights
from pyhrg.common.arrays import Array

COLUMNS = ("effect", "axis", "north_sigma_m", "east_sigma_m")
INITIAL, NOISE = "alignment beyond its sensors' means", "random walks"


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
