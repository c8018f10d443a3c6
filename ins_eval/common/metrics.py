"""Statistics of position errors, with confidence intervals."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.stats import binom, ttest_1samp

from pyhrg.common.pages.svg import format_interval

MIN_SAMPLE_FOR_MEDIAN = 6
"""Smallest sample whose range contains the median with 95 % confidence: 1 - 2 / 2^6 = 96.9 %."""


def median_interval(sample: ArrayLike, confidence: float = 0.95) -> tuple[float, float]:
    """Distribution-free confidence interval of a sample's median.

    The interval reaches from the k-th smallest to the k-th largest value. k is the largest number
    with a binomial probability P(fewer than k values below the median) <= (1 - confidence)/2.
    """
    ordered = np.sort(np.asarray(sample, dtype=float))
    n = len(ordered)
    below = int(binom.ppf((1 - confidence) / 2, n, 0.5)) - 1
    if below < 0:
        raise ValueError(f"{n} values can't bound the median with {confidence:.0%} confidence")
    return float(ordered[below]), float(ordered[n - 1 - below])


@dataclass(frozen=True)
class PairedRatio:
    """Geometric mean of the ratios of paired samples, with its 95 % confidence interval."""

    value: float
    low: float
    high: float

    def __str__(self) -> str:
        return f"{format_interval(self.value, self.low, self.high)}, 95 %"


def compute_paired_ratio(sample: ArrayLike, reference: ArrayLike) -> PairedRatio:
    """Geometric mean ratio of two positive samples (n,), compared pair by pair.

    The interval is Student's t on the logarithms: the ratio of radial errors is far from normal,
    its logarithm is close to it. If all ratios are equal, the interval has width 0.
    """
    logarithm = np.log(np.asarray(sample, dtype=float) / np.asarray(reference, dtype=float))
    mean = float(np.mean(logarithm))
    if np.ptp(logarithm) == 0:
        return PairedRatio(*[float(np.exp(mean))] * 3)
    low, high = ttest_1samp(logarithm, 0.0).confidence_interval(0.95)
    return PairedRatio(*(float(np.exp(value)) for value in (mean, low, high)))
