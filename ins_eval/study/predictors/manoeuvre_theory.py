"""Predictor (3): a bias stability and a theory that knows the manoeuvre, but not the device's map.

The stability is that of a bias map whose harmonics have random phases; how far each axis' pattern
turns, what alignment hides and Schuler's period are in the mission's weights. A static bench test
tells nothing of the scale factor's map, and neither does this.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.study.predictors.prediction import Normal

Array = NDArray[np.float64]

FOURTH = np.array([float(h == 4) for h in HARMONICS])
"""Share of a map's variance in each of `HARMONICS` when nothing else is known."""


def predict(
    stability: Array, weights: MissionWeights, rest: Array, shares: Array = FOURTH
) -> Normal:
    """Of triads.

    A harmonic of amplitude a and random phase has cosine and sine of variance a^2/2 each, which is
    its part of the stability squared.

    Args:
        stability: (r, 3) rad/s.
        weights: of the mission.
        rest: (r, k, 2, 2) covariance of what maps don't tell, m^2.
        shares: (4,) of the variance in each of `HARMONICS`; their sum is 1.
    """
    waves = weights.gyros[:, :, 1:TERMS]
    power = np.einsum("kica,c,kjca->kija", waves, np.repeat(shares, 2), waves)
    covariance = rest + np.einsum("kija,ra->rkij", power, stability**2)
    return Normal(np.zeros(covariance.shape[:-1]), covariance)


def harmonic_shares(maps: Array) -> Array:
    """(4,) share of each of `HARMONICS` in the variance of bias maps (r, c, 3), c TERMS or
    more: of those of the training half."""
    power = np.mean(maps[:, 1:TERMS] ** 2, axis=(0, 2)).reshape(len(HARMONICS), 2).sum(axis=1)
    return np.asarray(power / power.sum())
