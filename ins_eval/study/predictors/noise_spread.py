"""How far gyro noise spreads the position in a mission: once for all devices.

The linear model's response of the kept errors to the rate error of each step, weighed with the
filters that shape white noise into flicker and rate random walk: half and whole integrators
(Kasdin 1995, Proc. IEEE 83, 802). Noise begins at power-on.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import fftconvolve

from ins_eval.study.mission_weights import STEP, MissionWeights
from ins_eval.study.predictors.knowledge import NoiseLevels

Array = NDArray[np.float64]


@dataclass(frozen=True)
class NoiseSpread:
    """Covariance (k, 2, 2, 3) of the error for a gyro along each axis, m^2, per unit of the noise's
    coefficient squared."""

    angle_random_walk: Array
    bias_instability: Array
    rate_random_walk: Array

    def covariance(self, levels: NoiseLevels) -> Array:
        """(r, k, 2, 2) m^2 of triads with these levels."""
        pairs = (
            (self.angle_random_walk, levels.angle_random_walk),
            (self.bias_instability, levels.bias_instability),
            (self.rate_random_walk, levels.rate_random_walk),
        )
        return np.asarray(sum(np.einsum("kija,ra->rkij", unit, level**2) for unit, level in pairs))


def noise_spread(weights: MissionWeights) -> NoiseSpread:
    """Of a mission."""
    response = responses(weights)
    back = response[:, :, ::-1]
    walk = np.cumsum(back, axis=2)
    flicker = fftconvolve(back, _half_integrator(back.shape[2])[:, None], axes=2)
    return NoiseSpread(
        angle_random_walk=_power(response) / STEP,
        bias_instability=_power(flicker[:, :, : back.shape[2]]),
        rate_random_walk=_power(walk) * STEP,
    )


def responses(weights: MissionWeights) -> Array:
    """(k, 2, n, 3) error north and east after each kept step, m, per mean rate error of each gyro
    over each step from power-on's end of settling, rad/s."""
    count, steps = len(weights.kept), len(weights.transition)
    response = np.zeros((count, 2, steps, 3))
    carried = np.zeros((count, 2, weights.transition.shape[-1]))
    place = {int(step): k for k, step in enumerate(weights.kept)}
    for step in range(steps, 0, -1):
        if step in place:
            carried[place[step], :, :2] = np.eye(2)
        response[:, :, step - 1] = carried @ weights.per_rate[step - 1]
        carried = carried @ weights.transition[step - 1]
    return response


def _half_integrator(count: int) -> Array:
    """First coefficients of (1 - 1/z)^(-1/2)."""
    n = np.arange(1.0, count)
    return np.concatenate([[1.0], np.cumprod((n - 0.5) / n)])


def _power(response: Array) -> Array:
    return np.asarray(np.einsum("kina,kjna->kija", response, response))
