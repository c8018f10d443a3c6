"""Standard deviation of values that differ by more than their noise, with a 95 % interval."""

import numpy as np
from numpy.typing import ArrayLike
from scipy import optimize, special, stats

from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array

NORMAL_SQUARE = 1e4
"""Sum of squares over the noise variance beyond which its root is taken as normal."""
NOISE_QUANTILES = 64
"""Number of quantiles of the noise's distribution over which an interval is averaged."""


def estimate_spread(
    name: str, samples: ArrayLike, noise: float, freedom: int, unit: str, note: str = ""
) -> Finding:
    """Standard deviation (n - 1) of samples (n,) that have fixed means and normal noise.

    The interval is for tau = sqrt(noise^2 + sum (mean - mean of means)^2 / (n - 1)), the root mean
    square of the deviation over repeats of the same test. For a tau above the noise, the sum of
    squares over noise^2 has a noncentral chi-square distribution; for a tau below the noise, the
    noise itself is taken as tau. The estimate always lies within the interval. Samples are (n,) SI;
    `noise` is the estimated standard deviation of a sample's noise, with its degrees of freedom.
    """
    values = np.asarray(samples, dtype=float)
    n = len(values)
    if n < 2:
        return Finding(name, np.nan, unit, n=n, note=note or f"{n} of at least 2 samples")
    value = float(np.std(values, ddof=1))
    if not noise > 0:
        return Finding(name, value, unit, n=n, note=note or "no noise known: no interval")
    # enlarged so that normal bounds equal Student's where the means differ by much
    enlarged = noise * float(stats.t.ppf(0.975, freedom) / stats.norm.ppf(0.975))
    low, high = (_compute_bound(value, enlarged, n - 1, p) for p in (0.975, 0.025))
    return Finding(name, value, unit, low, high, n, note)


def estimate_excess(
    name: str, square: float, noise: float, freedoms: tuple[int, int], unit: str, note: str = ""
) -> Finding:
    """Standard deviation of the true means of values, without their noise; 0 where noise alone
    explains how they differ.

    The interval inverts the noncentral chi-square distribution of `square`, averaged over the
    fiducial distribution of the noise: an F test where the means may be equal, Student's interval
    where they clearly differ. Its upper bound is at least that of values that differ by noise
    alone. `square` is the mean square (n - 1) of the values, `noise` the estimated standard
    deviation of a value's noise, SI; `freedoms` are the degrees of freedom of both.
    """
    of_square, of_noise = freedoms
    value, n = float(np.sqrt(max(square - noise**2, 0.0))), of_square + of_noise
    if not noise > 0:
        return Finding(name, value, unit, n=n, note=note or "no noise known: no interval")
    share = (np.arange(NOISE_QUANTILES) + 0.5) / NOISE_QUANTILES
    noises = noise * np.sqrt(of_noise / stats.chi2.ppf(share, of_noise))
    observed = float(np.sqrt(square))
    low = _compute_excess(observed, noises, of_square, 0.025)
    high = _compute_excess(max(observed, noise), noises, of_square, 0.975)
    return Finding(name, value, unit, low, high, n, note)


def _compute_bound(value: float, noise: float, freedom: int, probability: float) -> float:
    """True deviation for which an observed one of at most `value` has this probability."""
    if special.chdtr(freedom, freedom * (value / noise) ** 2) < probability:
        return value * float(np.sqrt(freedom / stats.chi2.ppf(probability, freedom)))
    excess = _compute_excess(value, np.array([noise]), freedom, 1 - probability)
    return float(np.hypot(noise, excess))


def _compute_excess(value: float, noises: Array, freedom: int, probability: float) -> float:
    """Deviation of the true means, at least 0, for which an observed deviation above `value` has
    this probability, averaged over noises (m,)."""

    def missing(excess: float) -> float:
        return float(np.mean(_compute_tail(value / noises, excess / noises, freedom))) - probability

    if missing(0.0) >= 0:
        return 0.0
    reach = 10 * (value + float(np.max(noises)))
    return float(optimize.brentq(missing, 0.0, reach, xtol=1e-9 * reach))


def _compute_tail(value: Array, excess: Array, freedom: int) -> Array:
    """Probability of an observed deviation above `value` where the true means deviate by `excess`;
    both in units of the noise."""
    total, beyond = freedom * value**2, freedom * excess**2
    near = special.chndtr(
        np.minimum(total, NORMAL_SQUARE), freedom, np.minimum(beyond, 2 * NORMAL_SQUARE)
    )
    far = stats.norm.cdf(np.sqrt(total) - np.sqrt(beyond + freedom))
    return np.asarray(1 - np.where(total < NORMAL_SQUARE, near, far))
