"""Amplitude of a fitted harmonic, with an interval that holds at zero as well."""

import math
from collections.abc import Callable

from scipy import optimize, stats

from pyhrg.bench.estimation.harmonics import Fit
from pyhrg.bench.outcome import Finding

CLEAR = 20.0
"""A length of so many standard errors is as good as normally distributed."""


def magnitude_finding(name: str, fitted: Fit, terms: tuple[str, str], unit: str) -> Finding:
    """Length of the vector of two terms of a fit.

    The square of the estimated length over its variance is a noncentral F variable; the interval
    holds every length for which what was found lies between the 2.5 and 97.5 % quantiles.

    Args:
        name, unit: of the finding.
        fitted: the fit, its residuals independent and normal.
        terms: names of the two.
    """
    rows = [fitted.names.index(term) for term in terms]
    vector = fitted.values[rows]
    length = math.hypot(*vector)
    covariance = fitted.covariance[rows][:, rows]
    direction = vector / length if length > 0 else vector
    along = float(direction @ covariance @ direction) or float(covariance.trace()) / 2
    low, high = interval(length, math.sqrt(along), fitted.freedom_of(*terms))
    return Finding(name, length, unit, low, high, len(fitted.residual))


def interval(length: float, deviation: float, freedom: float) -> tuple[float, float]:
    """95 % interval of the true length, from the estimate and the standard error of a term."""
    if deviation == 0.0:
        return length, length
    if length > CLEAR * deviation:
        reach = float(stats.t.ppf(0.975, freedom)) * deviation
        return length - reach, length + reach
    found = (length / deviation) ** 2 / 2

    def below(true: float) -> float:
        return float(stats.ncf.cdf(found, 2, freedom, true**2))

    ratio, reach = length / deviation, 10.0
    return (
        deviation * _crossing(below, 0.975, ratio + reach),
        deviation * _crossing(below, 0.025, ratio + reach),
    )


def _crossing(falling: Callable[[float], float], level: float, end: float) -> float:
    """Where a falling function meets a level; zero where it begins below."""
    start = 1e-6
    if falling(start) <= level:
        return 0.0
    return float(optimize.brentq(lambda x: falling(x) - level, start, end))
