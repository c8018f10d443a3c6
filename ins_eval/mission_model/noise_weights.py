"""Covariance of the position error in a mission per unit of each gyro noise.

The error is linear in the noise and the noise nearly Gaussian, so that the covariance describes it
completely; it is computed once for a mission (docs/methods/mission_model.md, Eqs. 10 and 11). The
processes are those of the FMU (`HRG.Noise.ElectronicsNoise`) in steps of the linear model; the
coefficients are those of IEEE Std 952, in the order of `COEFFICIENT_NAMES`.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

FMU_FLICKER_LAGS = 0.01 * 8.0 ** np.arange(8)
"""Time constants of the first-order lags of one white noise whose sum is the FMU's flicker noise,
s (`HRG.Noise.ElectronicsNoise`)."""
FMU_FLICKER_SCALE = np.log(8) / np.pi
"""Factor of their sum that makes its power spectral density B^2/(2 pi f)."""


def compute_error_weights(transition: Array, per_rate: Array, kept: NDArray[np.int64]) -> Array:
    """(2 k, n, s) error north and east at the kept times per sensor error in each step (Eq. 9).

    transition: (n, 10, 10) transition matrices of the linear model; per_rate: (n, 10, s) state
    error per mean error of each gyro's rate, or other sensor, over a step; kept: (k,) numbers of
    the steps after which errors are kept.
    """
    places = {step: i for i, step in enumerate(kept.tolist())}
    back = np.zeros((2 * len(kept), transition.shape[1]))
    weights = np.empty((len(transition), 2 * len(kept), per_rate.shape[-1]))
    for k in reversed(range(len(transition))):
        if k + 1 in places:
            first = 2 * places[k + 1]
            back[[first, first + 1], [0, 1]] = 1.0
        weights[k] = back @ per_rate[k]
        back = back @ transition[k]
    return np.ascontiguousarray(np.swapaxes(weights, 0, 1))


def compute_noise_covariances(weights: Array, step: float, before: int) -> Array:
    """(4, 3, 2 k, 2 k) covariance, m^2, per squared unit of each noise coefficient of each gyro.

    weights: result of `compute_error_weights`; step: step of the linear model, s; before: number of
    steps from power-on, where slow noise starts at zero, to the first step.
    """
    rows, _, axes = weights.shape
    covariances = np.empty((len(COEFFICIENT_NAMES), axes, rows, rows))
    for axis in range(axes):
        for kind, response in enumerate(_compute_responses(weights[:, :, axis], step, before)):
            covariances[kind, axis] = response @ response.T
    return covariances


def factor_covariances(covariances: Array) -> Array:
    """(..., m, m) matrices L with L L^T equal to the covariances, which may be singular."""
    values, vectors = np.linalg.eigh(covariances)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0))[..., None, :])


def _compute_responses(weights: Array, step: float, before: int) -> list[Array]:
    """(2 k, deviates) error per standard normal deviate, for each kind of noise (Eq. 10)."""
    since = np.concatenate([np.zeros((len(weights), before)), weights], axis=1)
    return [
        -np.diff(weights, prepend=0.0, append=0.0) / step,
        weights / np.sqrt(step),
        FMU_FLICKER_SCALE * sum(_weigh_lag(since, step, constant) for constant in FMU_FLICKER_LAGS),
        np.sqrt(step) * _sum_backwards(since, 1.0),
    ]


def _weigh_lag(weights: Array, step: float, constant: float) -> Array:
    decay = np.exp(-step / constant)
    return (1 - decay) * np.sqrt(constant / step) * _sum_backwards(weights, decay)


def _sum_backwards(weights: Array, decay: float) -> Array:
    """(2 k, n) sums over this and later steps of weight times decay^(steps between)."""
    return np.asarray(lfilter([1.0], [1.0, -decay], weights[:, ::-1], axis=1)[:, ::-1])
