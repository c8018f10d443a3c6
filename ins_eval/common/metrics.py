"""Figures of merit of position errors, with their intervals."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import binom, ttest_1samp

Array = NDArray[np.float64]

FEWEST_FOR_MEDIAN = 6
"""Smallest sample whose extremes hold the median with 95 % confidence: 1 - 2 / 2^6 = 96.9 %."""


def median_interval(sample: ArrayLike, confidence: float = 0.95) -> tuple[float, float]:
    """Confidence interval of the median from order statistics, without assumptions.

    The k-th and the k-th last value, with k - 1 the largest number of values that lie below the
    median with at most (1 - confidence)/2 of probability.

    Raises:
        ValueError: fewer than `FEWEST_FOR_MEDIAN` values for 95 %.
    """
    ordered = np.sort(np.asarray(sample, dtype=float))
    n = len(ordered)
    below = int(binom.ppf((1 - confidence) / 2, n, 0.5)) - 1
    if below < 0:
        raise ValueError(f"{n} values can't hold the median with {confidence:.0%} confidence")
    return float(ordered[below]), float(ordered[n - 1 - below])


@dataclass(frozen=True)
class PairedRatio:
    """Geometric mean of a sample's ratios to another, with its 95 % interval."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{self.value:.3g} (95 %: {self.low:.3g} to {self.high:.3g})"


def paired_ratio(sample: ArrayLike, reference: ArrayLike) -> PairedRatio:
    """Of positive samples (n,) of the same things, pair by pair: Student's t on the logarithms.

    The logarithm of a radial error's ratio is close to normal where that of the ratio is far from
    it. Pairs that are equal throughout give an interval of no width.
    """
    logarithm = np.log(np.asarray(sample, dtype=float) / np.asarray(reference, dtype=float))
    mean = float(np.mean(logarithm))
    if np.ptp(logarithm) == 0:
        return PairedRatio(*[float(np.exp(mean))] * 3)
    low, high = ttest_1samp(logarithm, 0.0).confidence_interval(0.95)
    return PairedRatio(*(float(np.exp(value)) for value in (mean, low, high)))
