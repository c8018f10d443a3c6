"""Predictor by a constant for each class of manoeuvre: error = constant x stability x time (Eq. 3).

The usual rule has one constant for all: 0.01 deg/h makes 1 nmi/h. Here the constant of a class is
the median, over the training triads and many start angles, of the linear flights' error in units of
that rule. Other quantiles of the same flights are the ends of the predicted interval.
"""

from dataclasses import dataclass

import numpy as np

from ins_eval.mission_model.mission_weights import MissionWeights
from ins_eval.mission_model.position_errors import TriadBlock
from ins_eval.study.predictors import true_parameters
from ins_eval.study.predictors.stability_rule import compute_rule_distance
from pyhrg.common.arrays import Array

FLIGHTS = 256
"""Number of start angles from which each training triad flies. Chosen."""


@dataclass(frozen=True)
class ScaledPrediction:
    """A distribution of the horizontal error: a distance (r, k), m, times these ratios."""

    distance: Array
    ratios: Array

    @property
    def expected(self) -> Array:
        """(r, k, 2) zeros: the rule knows no direction."""
        return np.zeros((*self.distance.shape, 2))

    def radius(self, share: float) -> Array:
        """(r, k) quantile of the horizontal error, m."""
        return np.asarray(self.distance * np.quantile(self.ratios, share))


def predict(ratios: Array, stability: Array, time: Array) -> ScaledPrediction:
    """Errors of triads by the class's ratios (r, n), errors of the training triads' flights in
    units of the usual rule; other arguments as `stability_rule.predict`."""
    return ScaledPrediction(compute_rule_distance(stability, time), ratios)


def fly_training_triads(
    weights: MissionWeights, training: TriadBlock, other: Array, seed: int
) -> Array:
    """(r, `FLIGHTS`) horizontal errors, m, of linear flights of the training triads.

    Args:
        weights: weights of the mission at its end alone.
        other: (r, 1, 2, 2) covariance of the error by noise, accelerometers and mounting, m^2.
        seed: seed of the start angles and of the noise.
    """
    flown = true_parameters.fly_from_any_angle(
        weights, training.in_flight, other, training.start_angle, seed
    )
    step = flown.samples.shape[1] // FLIGHTS
    return np.asarray(np.linalg.norm(flown.samples[:, ::step, -1], axis=-1))


def compute_constant(ratios: Array) -> Array:
    """(...,) constant of a class from ratios (..., r, n), in units of the usual rule."""
    return np.asarray(np.median(ratios, axis=(-2, -1)))
