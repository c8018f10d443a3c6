"""Standard deviation of values that differ by more than noise, with an interval."""

import numpy as np
from numpy.typing import ArrayLike
from scipy import optimize, stats

from pyhrg.bench.outcome import Finding

NORMAL = 1e6
"""Sum of squares over noise^2 beyond which its distribution is normal to a thousandth."""


def spread_finding(
    name: str, samples: ArrayLike, noise: float, unit: str, note: str = ""
) -> Finding:
    """Standard deviation (n - 1) of samples (n,) with fixed means and normal noise.

    The interval holds sqrt(noise^2 + sum (mean - mean of means)^2 / (n - 1)), the deviation that
    repeats of the same test have in the mean square: the sum of squares over noise^2 is noncentral
    chi-square, whose noncentrality is what the interval bounds.

    Args:
        name: of the figure.
        samples: (n,), SI.
        noise: standard deviation of one sample's noise, SI, well known.
        unit: to be shown in.
        note: of the finding.
    """
    values = np.asarray(samples, dtype=float)
    n = len(values)
    if n < 2:
        return Finding(name, np.nan, unit, n=n, note=note or f"{n} of at least 2 samples")
    value = float(np.std(values, ddof=1))
    if not noise > 0:
        return Finding(name, value, unit, n=n, note=note or "no noise known: no interval")
    freedom = n - 1
    total = freedom * (value / noise) ** 2
    low, high = (
        noise * np.sqrt(1 + _noncentrality(total, freedom, p) / freedom) for p in (0.975, 0.025)
    )
    if value < low:
        note += (
            f"{'; ' if note else ''}less than noise alone leaves, from which the interval begins"
        )
    return Finding(name, value, unit, float(low), float(high), n, note)


def _noncentrality(total: float, freedom: int, probability: float) -> float:
    """Noncentrality at which a sum of squares is at most `total` with this probability; 0 where
    even that is too much."""

    def excess(noncentrality: float) -> float:
        return float(stats.ncx2.cdf(total, freedom, noncentrality)) - probability

    if stats.chi2.cdf(total, freedom) < probability:
        return 0.0
    if total > NORMAL:
        reach = float(stats.norm.ppf(probability)) * 2 * np.sqrt(total)
        return float(max(total - freedom - reach, 0.0))
    top = total + 10 * np.sqrt(total + freedom) + 40
    return float(optimize.brentq(excess, 1e-9, top))
