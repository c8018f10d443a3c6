"""What the noise of a gyro does to the position in a mission, as covariances per unit of noise.

The error is linear in the noise, and the noise nearly Gaussian: a covariance says all, and costs
a triad nothing. The processes are those of the FMU (`HRG.Noise.ElectronicsNoise`), in steps of the
linear model; coefficients are those of IEEE Std 952.
"""

import numpy as np
from numpy.typing import NDArray
from scipy.signal import lfilter

Array = NDArray[np.float64]

KINDS = ("angle white noise", "angle random walk", "bias instability", "rate random walk")
"""In units of rad (one sample of the output), rad/sqrt(s), rad/s, rad/s/sqrt(s)."""
TIME_CONSTANTS = 0.01 * 8.0 ** np.arange(8)
"""Of the lags whose sum is flicker noise, s."""
FLICKER = np.log(8) / np.pi
"""Scale of their sum, for the density B^2/(2 pi f)."""


def error_weights(transition: Array, per_rate: Array, kept: NDArray[np.int64]) -> Array:
    """(2 k, n, 3) error north and east at the kept times per rate error in each step.

    Args:
        transition: (n, 10, 10) of the linear model.
        per_rate: (n, 10, 3) what a gyro's mean rate error over a step adds.
        kept: (k,) steps after which errors are told.
    """
    places = {step: i for i, step in enumerate(kept.tolist())}
    back = np.zeros((2 * len(kept), transition.shape[1]))
    weights = np.empty((len(transition), 2 * len(kept), 3))
    for k in reversed(range(len(transition))):
        if k + 1 in places:
            first = 2 * places[k + 1]
            back[[first, first + 1], [0, 1]] = 1.0
        weights[k] = back @ per_rate[k]
        back = back @ transition[k]
    return np.ascontiguousarray(np.swapaxes(weights, 0, 1))


def noise_covariances(weights: Array, step: float, before: int) -> Array:
    """(KINDS, 3, 2 k, 2 k) m^2 per squared unit of each kind of each gyro's noise.

    Args:
        weights: of `error_weights`.
        step: s.
        before: steps from power-on, at which the slow noise begins at zero, to the first of them.
    """
    rows, _, axes = weights.shape
    covariances = np.empty((len(KINDS), axes, rows, rows))
    for axis in range(axes):
        for kind, response in enumerate(_responses(weights[:, :, axis], step, before)):
            covariances[kind, axis] = response @ response.T
    return covariances


def factors(covariances: Array) -> Array:
    """Square roots L, L L^T the covariances (..., m, m), which may be singular."""
    values, vectors = np.linalg.eigh(covariances)
    return np.asarray(vectors * np.sqrt(np.maximum(values, 0.0))[..., None, :])


def _responses(weights: Array, step: float, before: int) -> list[Array]:
    """(2 k, deviates) error per standard normal deviate of each kind of noise."""
    since = np.concatenate([np.zeros((len(weights), before)), weights], axis=1)
    return [
        -np.diff(weights, prepend=0.0, append=0.0) / step,
        weights / np.sqrt(step),
        FLICKER * sum(_through_lag(since, step, constant) for constant in TIME_CONSTANTS),
        np.sqrt(step) * _summed_back(since, 1.0),
    ]


def _through_lag(weights: Array, step: float, constant: float) -> Array:
    decay = np.exp(-step / constant)
    return (1 - decay) * np.sqrt(constant / step) * _summed_back(weights, decay)


def _summed_back(weights: Array, decay: float) -> Array:
    """Of each step's deviate: what stays of it in later steps, times their weights."""
    return np.asarray(lfilter([1.0], [1.0, -decay], weights[:, ::-1], axis=1)[:, ::-1])
