"""Allan deviation of an angle record, with intervals."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import chi2

from pyhrg.noise.likelihood import Array, spectrum
from pyhrg.noise.model import CONFIDENCE, NoiseCoefficients, check_record, fit

CLUSTERS_CORRELATED = 16
"""Cluster times after which the second differences of even flicker are as good as independent."""


@dataclass(frozen=True)
class AllanDeviation:
    """Overlapping Allan deviation at m cluster times, with 95 % intervals, each for itself."""

    tau: Array
    """(m,) cluster times, s."""
    deviation: Array
    """(m,) rad/s."""
    low: Array
    """(m,) lower end of the interval, rad/s."""
    high: Array
    """(m,) upper end of the interval, rad/s."""
    freedom: Array
    """(m,) equivalent degrees of freedom."""
    n: int
    """Number of angles."""

    def up_to(self, tau: float) -> "AllanDeviation":
        """Its cluster times up to one, s."""
        kept = self.tau <= tau
        names = ("tau", "deviation", "low", "high", "freedom")
        return replace(self, **{name: getattr(self, name)[kept] for name in names})


def allan_deviation(angle: Array, interval: float, per_octave: int = 4) -> AllanDeviation:
    """Overlapping Allan deviation of the rate, from the angle itself (IEEE Std 952, annex C).

    An interval is chi-squared with the degrees of freedom that the second differences have under
    the noises identified in the record (C. Greenhall, W. Riley, Uncertainty of stability
    variances based on finite differences, PTTI 2003; there for one power law at a time). It holds
    for the noises; a rate ramp adds to the deviation and is not random.

    Args:
        angle: (n,) rad, evenly spaced, without gaps.
        interval: between angles, s.
        per_octave: cluster times in a factor of two, where whole multiples of the interval allow.

    Raises:
        NoiseError: a record that `identify` would refuse.
    """
    check_record(angle, interval)
    strengths = fit([spectrum(angle)])
    clusters = _clusters(len(angle) // 3, per_octave)
    deviation = np.array([_deviation(angle, m) for m in clusters]) / (clusters * interval)
    freedom = np.array([_freedom(strengths, len(angle) - 2 * m, m) for m in clusters])
    tail = (1 - CONFIDENCE) / 2
    return AllanDeviation(
        tau=clusters * interval,
        deviation=deviation,
        low=deviation * np.sqrt(freedom / chi2.isf(tail, freedom)),
        high=deviation * np.sqrt(freedom / chi2.ppf(tail, freedom)),
        freedom=freedom,
        n=len(angle),
    )


def expected_deviation(tau: ArrayLike, noises: NoiseCoefficients) -> Array:
    """Allan deviation that coefficients promise, rad/s, at cluster times (s): IEEE Std 952."""
    t = np.asarray(tau, dtype=np.float64)
    return np.sqrt(
        3 * (noises.white_angle.value / t) ** 2
        + noises.angle_random_walk.value**2 / t
        + 2 * np.log(2) / np.pi * noises.bias_instability.value**2
        + noises.rate_random_walk.value**2 * t / 3
    )


def _clusters(most: int, per_octave: int) -> Array:
    steps = np.arange(np.floor(per_octave * np.log2(most)) + 1)
    return np.unique(np.round(2 ** (steps / per_octave)).astype(int))


def _deviation(angle: Array, m: int) -> float:
    """Allan deviation times the cluster time, rad."""
    second = angle[2 * m :] - 2 * angle[m:-m] + angle[: -2 * m]
    return float(np.sqrt(np.mean(second**2) / 2))


def _freedom(strengths: Array, count: int, m: int) -> float:
    """Equivalent degrees of freedom of the mean square of so many overlapping second differences.

    Args:
        strengths: (4,) of the noises, rad^2.
        count: of second differences.
        m: angles in a cluster.
    """
    lag = np.arange(min(count, CLUSTERS_CORRELATED * m), dtype=np.float64)
    covariance = sum(
        weight * _covariance(strengths, lag + shift * m)
        for shift, weight in zip((-2, -1, 0, 1, 2), (1, -4, 6, -4, 1), strict=True)
    )
    square = (covariance / np.max(np.abs(covariance))) ** 2
    return float(count**2 * square[0] / (2 * (count - lag) @ square - count * square[0]))


def _covariance(strengths: Array, lag: Array) -> Array:
    """Generalized covariance of the angle, rad^2: transforms of the densities omega^-p."""
    t = np.abs(lag)
    kernels = [t == 0, -t / 2, t**2 * np.log(np.maximum(t, 1)) / (2 * np.pi), t**3 / 12]
    return np.asarray(strengths @ np.array(kernels))
