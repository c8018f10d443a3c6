"""Noise coefficients of an angle record, with intervals."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, nnls
from scipy.stats import norm

from pyhrg.noise.likelihood import POWERS, Array, Misfit, Spectrum, estimator, misfit, spectrum

CONFIDENCE = 0.95
LEAST_SAMPLES = 256
QUANTILE = float(norm.ppf(0.5 + CONFIDENCE / 2))
ITERATIONS = 1000
ROUNDING = 1e-14
HALVINGS = 12
DOUBLINGS = 40
SETTLED = 1e-5
"""Change of the misfit at which a fit has ended."""


class NoiseError(ValueError):
    """The record can't give what is asked of it; the message says why."""


@dataclass(frozen=True)
class Coefficient:
    """One noise coefficient and its 95 % interval.

    One that the record doesn't show has `low` zero: it is below `high`.
    """

    value: float
    low: float
    high: float

    @property
    def present(self) -> bool:
        """Whether the interval excludes zero."""
        return self.low > 0 or self.high < 0


@dataclass(frozen=True)
class NoiseCoefficients:
    """Four coefficients of IEEE Std 952, annex C; SI. Its fifth, a rate ramp, is no noise."""

    white_angle: Coefficient
    """White noise of one angle reading; of quantisation it is the step over sqrt(12) [Q], rad."""
    angle_random_walk: Coefficient
    """[N], rad/sqrt(s)."""
    bias_instability: Coefficient
    """Flicker [B], rad/s; the Allan deviation's floor is sqrt(2 ln 2/pi) = 0.664 of it."""
    rate_random_walk: Coefficient
    """[K], rad/s/sqrt(s)."""


def identify(angle: Array, interval: float) -> NoiseCoefficients:
    """Noise coefficients of one record; a constant rate and a rate ramp do not touch them.

    Args:
        angle: (n,) rad, evenly spaced, without gaps; anything else that is no noise taken out.
        interval: between angles, s.

    Raises:
        NoiseError: as `check_record`, or the record bounds a coefficient nowhere.
    """
    check_record(angle, interval)
    return coefficients([spectrum(np.asarray(angle, dtype=np.float64))], interval)


def coefficients(records: Sequence[Spectrum], interval: float) -> NoiseCoefficients:
    """Noise coefficients by restricted maximum likelihood, intervals by its profile.

    Intervals are ordered by the likelihood ratio to strengths that can't be negative (G. Feldman,
    R. Cousins, Phys. Rev. D 57 (1998)), so that one rule gives a bound where a noise isn't seen and
    two ends where it is. The signed root of the ratio is normal about minus a sixth of the
    estimator's skewness (O. Barndorff-Nielsen, Biometrika 73 (1986)), which matters where a few
    slow frequencies show a noise; it is heeded at the end that it moves outwards.
    `benchmarks/intervals/noise.py` measures what they cover.

    Args:
        records: that share their noises, each without what is no noise.
        interval: between angles, s.

    Raises:
        NoiseError: the records bound a coefficient nowhere.
    """
    best = fit(records)
    units = [interval ** ((1 - max(power, 1)) / 2) for power in POWERS]
    noises = [_scaled(_strength(records, best, i), unit) for i, unit in enumerate(units)]
    return NoiseCoefficients(*noises)


def check_record(angle: Array, interval: float) -> None:
    """Refuse a record that has no noise to be identified.

    Raises:
        NoiseError: fewer than 256 angles, one that is not finite, no noise at all, or an interval
            that is not positive.
    """
    if not (math.isfinite(interval) and interval > 0):
        raise NoiseError(f"interval is {interval} s, expected more than 0")
    if np.ndim(angle) != 1 or len(angle) < LEAST_SAMPLES:
        found = f"shape {np.shape(angle)}"
        raise NoiseError(f"angles are of {found}, expected ({LEAST_SAMPLES} or more,)")
    if not np.all(np.isfinite(angle)):
        first = int(np.argmin(np.isfinite(angle)))
        raise NoiseError(
            f"angle {first} is {angle[first]}, expected a stretch without gaps, in rad"
        )
    line = np.polynomial.Polynomial.fit(np.arange(len(angle)), angle, 2)
    if np.std(angle - line(np.arange(len(angle)))) <= ROUNDING * np.max(np.abs(angle)):
        raise NoiseError("the angles are a parabola: no noise beyond rounding")


def fit(
    records: Sequence[Spectrum],
    held: int | None = None,
    strength: float = 0.0,
    start: Array | None = None,
) -> Array:
    """Strengths of greatest restricted likelihood, none of them negative.

    Args:
        records: of the angles.
        held: index of a noise whose strength is given.
        strength: that strength, rad^2.
        start: (4,) strengths to begin at; otherwise the largest that nowhere exceed the record.

    Returns:
        (4,) variances, rad^2, in the order of `noise_likelihood.POWERS`.

    Raises:
        NoiseError: the angles have no noise that could be told from rounding.
    """
    free = [i for i in range(len(POWERS)) if i != held]
    point = largest(records) if start is None else np.array(start)
    if held is not None:
        point[held] = strength
    here = misfit(records, point)
    for _ in range(ITERATIONS):
        goal = _least(here, free, point)
        there = misfit(records, goal)
        for _ in range(HALVINGS):
            if there.value <= here.value:
                break
            goal = (point + goal) / 2
            there = misfit(records, goal)
        if here.value - there.value < SETTLED:
            return point
        point, here = goal, there
    raise NoiseError(f"the noise model has not settled in {ITERATIONS} iterations")


def largest(records: Sequence[Spectrum]) -> Array:
    """(4,) greatest strengths that nowhere exceed a record, rad^2."""
    each = [np.min(r.power / r.count / r.shapes, axis=1) for r in records]
    return np.asarray(np.min(each, axis=0))


def _least(model: Misfit, free: list[int], point: Array) -> Array:
    """Where the quadratic model is least, over free strengths that are not negative."""
    goal = point.copy()
    held = [i for i in range(len(point)) if i not in free]
    pull = model.pull[free] - model.information[np.ix_(free, held)] @ point[held]
    unit = 1 / np.sqrt(np.diag(model.information)[free])
    root = np.linalg.cholesky(model.information[np.ix_(free, free)] * np.outer(unit, unit))
    goal[free] = unit * nnls(root.T, np.linalg.solve(root, unit * pull))[0]
    return goal


def _strength(records: Sequence[Spectrum], best: Array, index: int) -> tuple[float, float, float]:
    """Square root of one strength, and its interval, rad."""
    least = misfit(records, best).value
    value = math.sqrt(best[index])
    tiny = 1e-6 * largest(records)

    def excess(root: float) -> float:
        point = fit(records, index, root**2, best + tiny)
        here = misfit(records, point)
        deviation, skewness = estimator(records, here, point, index)
        reach = math.sqrt(critical_ratio(root**2 / deviation))
        reach += max(0.0, math.copysign(skewness / 6, root - value))
        return here.value - least - reach**2

    spread = QUANTILE * estimator(records, misfit(records, best), best, index)[0]
    step = math.sqrt(best[index] + spread) - value
    low = 0.0 if value == 0 or excess(0.0) <= 0 else _crossing(excess, 0.0, value)
    return value, low, _crossing(excess, value, _beyond(excess, value, step))


def critical_ratio(distance: float) -> float:
    """Twice the log likelihood ratio that 95 % of records stay below.

    Args:
        distance: of the true strength from zero, in its standard deviations.
    """
    if distance >= QUANTILE:
        return QUANTILE**2
    if distance < 1e-6:
        return float(norm.isf(1 - CONFIDENCE)) ** 2

    def uncovered(ratio: float) -> float:
        below = norm.cdf(-(distance**2 + ratio) / (2 * distance))
        return float(norm.sf(math.sqrt(ratio)) + below - (1 - CONFIDENCE))

    return float(brentq(uncovered, distance**2, QUANTILE**2))


def _beyond(excess: Callable[[float], float], inside: float, step: float) -> float:
    """A point outside the interval, on the side of the step."""
    for _ in range(DOUBLINGS):
        if excess(inside + step) > 0:
            return inside + step
        step *= 2
    raise NoiseError("the record is too short to bound one of its noise coefficients")


def _crossing(excess: Callable[[float], float], first: float, last: float) -> float:
    return float(brentq(excess, first, last, xtol=1e-3 * abs(last - first), rtol=1e-3))


def _scaled(interval: tuple[float, float, float], unit: float) -> Coefficient:
    return Coefficient(*(unit * x for x in interval))
