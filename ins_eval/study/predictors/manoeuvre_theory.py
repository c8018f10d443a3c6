"""Predictor (3): a bias stability through a theory that knows the mission, but not the gyro's map.

The bias map is taken to have harmonics of random phases and the measured stability (Eq. 3). The
mission's weights contain the turn of each pattern, the part of the error that alignment hides and
the Schuler oscillation. The scale factor's map is left out: a static bench test does not measure
it.
"""

import numpy as np
from numpy.typing import NDArray

from ins_eval.mission_model.gyro_map import HARMONICS, TERMS
from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.study.predictors.prediction import NormalPrediction

Array = NDArray[np.float64]

FOURTH_ONLY = np.array([float(h == 4) for h in HARMONICS])
"""Share of a map's variance in each of `HARMONICS` where nothing else is known: all in the
fourth."""


def predict(
    stability: Array, weights: MissionWeights, other: Array, shares: Array = FOURTH_ONLY
) -> NormalPrediction:
    """Errors of triads, by a normal distribution about zero.

    A harmonic of amplitude a and random phase has cosine and sine coefficients of variance a^2/2
    each; that is also its part of the squared stability.

    Args:
        stability: (r, 3) bias stabilities, rad/s.
        weights: weights of the mission.
        other: (r, k, 2, 2) covariance of the error by noise and accelerometers, m^2.
        shares: (4,) shares of the variance in each of `HARMONICS`; their sum is 1.
    """
    waves = weights.gyros[:, :, 1:TERMS]
    power = np.einsum("kica,c,kjca->kija", waves, np.repeat(shares, 2), waves)
    covariance = other + np.einsum("kija,ra->rkij", power, stability**2)
    return NormalPrediction(np.zeros(covariance.shape[:-1]), covariance)


def estimate_harmonic_shares(maps: Array) -> Array:
    """(4,) share of each of `HARMONICS` in the variance of bias maps (r, c, 3) of the training
    half; c is TERMS or more."""
    power = np.mean(maps[:, 1:TERMS] ** 2, axis=(0, 2)).reshape(len(HARMONICS), 2).sum(axis=1)
    return np.asarray(power / power.sum())
