"""Amplitude of a fitted harmonic, with a 95 % interval that is also correct near zero."""

import math
from collections.abc import Callable

from scipy import optimize, stats

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.outcome import Finding

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

    ratio, reach = length / deviation, 10.0
    return (
        deviation * _find_crossing(below, 0.975, ratio + reach),
        deviation * _find_crossing(below, 0.025, ratio + reach),
    )


def _find_crossing(falling: Callable[[float], float], level: float, end: float) -> float:
    """Argument at which a falling function meets a level; zero where it begins below the level."""
    start = 1e-6
    if falling(start) <= level:
        return 0.0
    return float(optimize.brentq(lambda x: falling(x) - level, start, end))
