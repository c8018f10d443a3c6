"""Standard deviation of values that differ by more than noise, with an interval."""

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy import optimize, special, stats

from pyhrg.bench.outcome import Finding

Array = NDArray[np.float64]

LARGE = 1e4
"""Sum of squares over noise^2 beyond which its root is normal."""
LEVELS = 64
"""Quantiles of the noise that an interval is averaged over."""


def spread_finding(
    name: str, samples: ArrayLike, noise: float, freedom: int, unit: str, note: str = ""
) -> Finding:
    """Standard deviation (n - 1) of samples (n,) with fixed means and normal noise.

    The interval holds tau = sqrt(noise^2 + sum (mean - mean of means)^2 / (n - 1)), the deviation
    that repeats of the same test have in the mean square: every tau that the sum of squares does
    not contradict. Of a tau above the noise the sum over noise^2 is noncentral chi-square; of one
    below, all is noise, which is then tau itself. The estimate is within the interval always.

    Args:
        name: of the figure.
        samples: (n,), SI.
        noise: standard deviation of one sample's noise, as measured, SI.
        freedom: degrees of freedom that `noise` is known with.
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
    # wide enough for normal bounds to become Student's where the means differ by much
    believed = noise * float(stats.t.ppf(0.975, freedom) / stats.norm.ppf(0.975))
    low, high = (_bound(value, believed, n - 1, p) for p in (0.975, 0.025))
    return Finding(name, value, unit, low, high, n, note)


def excess_finding(
    name: str, square: float, noise: float, freedoms: tuple[int, int], unit: str, note: str = ""
) -> Finding:
    """By how much values differ beyond noise: standard deviation of their means, 0 for none.

    The interval inverts the noncentral chi-square distribution of `square`, averaged over what the
    noise may be (fiducial): an F test where the means may be equal, Student's where they differ.
    Its high end is no lower than that of values that differ as noise alone makes them.

    Args:
        name: of the figure.
        square: mean square (n - 1) of the values, SI.
        noise: standard deviation of one value's noise, as measured, SI.
        freedoms: degrees of freedom of `square` and of `noise`.
        unit: to be shown in.
        note: of the finding.
    """
    of_square, of_noise = freedoms
    value, n = float(np.sqrt(max(square - noise**2, 0.0))), of_square + of_noise
    if not noise > 0:
        return Finding(name, value, unit, n=n, note=note or "no noise known: no interval")
    share = (np.arange(LEVELS) + 0.5) / LEVELS
    noises = noise * np.sqrt(of_noise / stats.chi2.ppf(share, of_noise))
    seen, least = float(np.sqrt(square)), max(float(np.sqrt(square)), noise)
    low = _excess(seen, noises, of_square, 0.025)
    high = _excess(least, noises, of_square, 0.975)
    return Finding(name, value, unit, low, high, n, note)


def _bound(value: float, noise: float, freedom: int, probability: float) -> float:
    """Deviation of which one of `value` at most has this probability."""
    if special.chdtr(freedom, freedom * (value / noise) ** 2) < probability:
        return value * float(np.sqrt(freedom / stats.chi2.ppf(probability, freedom)))
    excess = _excess(value, np.array([noise]), freedom, 1 - probability)
    return float(np.hypot(noise, excess))


def _excess(value: float, noises: Array, freedom: int, probability: float) -> float:
    """Deviation of means, at least 0, of which one above `value` has this probability, averaged
    over noises (m,)."""

    def missing(excess: float) -> float:
        return float(np.mean(_above(value / noises, excess / noises, freedom))) - probability

    if missing(0.0) >= 0:
        return 0.0
    reach = 10 * (value + float(np.max(noises)))
    return float(optimize.brentq(missing, 0.0, reach, xtol=1e-9 * reach))


def _above(value: Array, excess: Array, freedom: int) -> Array:
    """Probability of a deviation above `value` of means that differ by `excess`, in noises."""
    total, beyond = freedom * value**2, freedom * excess**2
    near = special.chndtr(np.minimum(total, LARGE), freedom, np.minimum(beyond, 2 * LARGE))
    far = stats.norm.cdf(np.sqrt(total) - np.sqrt(beyond + freedom))
    return np.asarray(1 - np.where(total < LARGE, near, far))
