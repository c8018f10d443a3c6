"""Estimates of sizes that are measured with noise: lengths, amplitudes, anisotropies, the largest
of means, the standard deviation of values that differ by more than their noise.

Their 95 % intervals are also correct near zero.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike
from scipy import optimize, special, stats

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.outcome import Finding
from pyhrg.common.arrays import Array


def estimate_magnitude(
    values: Array, covariance: Array, confidence: float = 0.95
) -> tuple[float, float, float]:
    """Length of the true vector and the bounds of its interval.

    The squared length of the measured vector is approximated by a scaled noncentral chi-square
    variable of the same mean and variance (exact where the covariance is a multiple of a
    projection). The interval inverts its distribution for the noncentrality. Components (n,) are
    normal and unbiased, their covariance is (n, n). The noise's expectation is subtracted from the
    estimate's square (at least 0). All is in the unit of the values.
    """
    square = float(values @ values)
    trace = float(np.trace(covariance))
    if trace <= 0.0:
        return (float(np.sqrt(square)),) * 3
    scale = float(np.trace(covariance @ covariance)) / trace
    along = float(values @ covariance @ values) / square if square > trace else scale
    scale = scale if square <= 9 * trace else along
    freedom = trace / scale

    def bound(probability: float) -> float:
        def excess(noncentrality: float) -> float:
            return float(special.chndtr(square / scale, freedom, noncentrality)) - probability

        if square / scale > 1e4:
            # far from zero the measured length is normally distributed
            reach = float(stats.norm.ppf(probability)) * np.sqrt(scale)
            return float(np.sqrt(square) - reach)
        if excess(0.0) <= 0.0:
            return 0.0
        upper = (np.sqrt(square / scale) + 6.0) ** 2
        return float(np.sqrt(scale * optimize.brentq(excess, 0.0, upper)))

    tail = (1 - confidence) / 2
    return float(np.sqrt(max(square - trace, 0.0))), bound(1 - tail), bound(tail)


def estimate_largest(samples: Array, confidence: float = 0.95) -> tuple[float, float, float]:
    """Largest absolute value of m means, and the bounds of its interval.

    Every mean has a Student's interval; the intervals hold simultaneously (Bonferroni) for all
    means that may be the largest. Means whose intervals show that they are not the largest are
    dropped, and the intervals are computed again, until none can be dropped. Samples are (n, m), n
    independent ones of the m means. The bounds are NaN where n is 1.
    """
    n, count = samples.shape
    means = np.abs(np.mean(samples, axis=0))
    if n < 2:
        return float(np.max(means)), np.nan, np.nan
    errors = np.std(samples, axis=0, ddof=1) / np.sqrt(n)
    while True:
        reach = errors * stats.t.ppf(1 - (1 - confidence) / (2 * count), n - 1)
        low = max(0.0, float(np.max(means - reach)))
        high = means + reach
        candidates = int(np.sum(high >= low))
        if candidates >= count:
            return float(np.max(means)), low, float(np.max(high))
        count = candidates


NORMAL_RATIO = 20.0
"""Ratio of an amplitude to its standard error above which its estimate is taken as normal."""


def estimate_amplitude(name: str, fitted: Fit, terms: tuple[str, str], unit: str) -> Finding:
    """Amplitude of a harmonic: length of the vector of its two terms.

    The squared estimate over its variance has a noncentral F distribution. The interval holds every
    length for which the estimate lies between the 2.5 % and 97.5 % quantiles.
    """
    rows = [fitted.names.index(term) for term in terms]
    vector = fitted.values[rows]
    length = math.hypot(*vector)
    covariance = fitted.covariance[rows][:, rows]
    direction = vector / length if length > 0 else vector
    along = float(direction @ covariance @ direction) or float(covariance.trace()) / 2
    low, high = compute_length_interval(length, math.sqrt(along), fitted.freedom_of(*terms))
    return Finding(name, length, unit, low, high, len(fitted.residual))


def compute_length_interval(length: float, deviation: float, freedom: float) -> tuple[float, float]:
    """95 % interval of a true length, from its estimate and the standard error of a component."""
    if deviation == 0.0:
        return length, length
    if length > NORMAL_RATIO * deviation:
        reach = float(stats.t.ppf(0.975, freedom)) * deviation
        return length - reach, length + reach
    statistic = (length / deviation) ** 2 / 2

    def below(true: float) -> float:
        return float(stats.ncf.cdf(statistic, 2, freedom, true**2))

    end = length / deviation + 10.0
    low, high = (_find_crossing(below, level, end) for level in (0.975, 0.025))
    return deviation * low, deviation * high


def _find_crossing(falling: Callable[[float], float], level: float, end: float) -> float:
    """Argument at which a falling function meets a level; zero where it begins below the level."""
    start = 1e-6
    if falling(start) <= level:
        return 0.0
    return float(optimize.brentq(lambda x: falling(x) - level, start, end))


def estimate_anisotropy(
    fit: Fit, components: tuple[str, str], name: str, axis: str, unit: str
) -> tuple[Finding, Finding]:
    """Size m and axis th of an anisotropy with the components m cos 4th and m sin 4th.

    The axis lies in 0 to 90 deg; an interval that holds 90 deg is given about 0 deg instead. Where
    the components' 95 % confidence ellipse holds zero, the size has an upper bound only and
    the axis has no value.
    """
    index = [fit.names.index(component) for component in components]
    value = fit.values[index]
    covariance = fit.covariance[np.ix_(index, index)]
    n = len(fit.residual)
    size = float(np.hypot(*value))
    distance = float(value @ np.linalg.pinv(covariance) @ value)
    reach = float(stats.t.ppf(0.975, fit.freedom))
    if distance <= 2 * stats.f.ppf(0.95, 2, fit.freedom):
        bound = size + reach * float(np.sqrt(np.linalg.eigvalsh(covariance)[-1]))
        note = "not different from zero: upper bound"
        return (
            Finding(name, size, unit, 0.0, bound, n, note),
            Finding(axis, np.nan, "deg", n=n, note=f"{name} is not different from zero"),
        )
    along = value / size
    across = np.array([-along[1], along[0]])
    radial = reach * float(np.sqrt(along @ covariance @ along))
    turned = reach * float(np.sqrt(across @ covariance @ across)) / size / 4
    angle = float(np.arctan2(value[1], value[0])) / 4 % (np.pi / 2)
    if angle + turned >= np.pi / 2:
        angle -= np.pi / 2
    return (
        Finding(name, size, unit, max(0.0, size - radial), size + radial, n),
        Finding(axis, angle, "deg", angle - turned, angle + turned, n, "modulo 90 deg"),
    )


def make_component_findings(
    fit: Fit, components: tuple[str, str], name: str, unit: str
) -> tuple[Finding, ...]:
    """Findings of the two components m cos 4th and m sin 4th."""
    return tuple(
        fit.finding(term, f"{name} {trig}4", unit)
        for term, trig in zip(components, ("cos", "sin"), strict=True)
    )


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
    far = special.ndtr(np.sqrt(total) - np.sqrt(beyond + freedom))
    return np.asarray(1 - np.where(total < NORMAL_SQUARE, near, far))
