"""Noise coefficients of an angle record, with intervals."""

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq, minimize, nnls
from scipy.stats import norm

from pyhrg.noise_likelihood import (
    POWERS,
    Array,
    Misfit,
    Spectrum,
    misfit,
    ramp_estimate,
    ramp_misfit,
    spectrum,
)

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
    """The five coefficients of IEEE Std 952, annex C; SI."""

    white_angle: Coefficient
    """White noise of one angle reading; of quantisation it is the step over sqrt(12) [Q], rad."""
    angle_random_walk: Coefficient
    """[N], rad/sqrt(s)."""
    bias_instability: Coefficient
    """Flicker [B], rad/s; the Allan deviation's floor is sqrt(2 ln 2/pi) = 0.664 of it."""
    rate_random_walk: Coefficient
    """[K], rad/s/sqrt(s)."""
    rate_ramp: Coefficient
    """[R], rad/s^2, with its sign."""


def identify(angle: Array, interval: float) -> NoiseCoefficients:
    """Noise coefficients by restricted maximum likelihood, intervals by its profile.

    Intervals are ordered by the likelihood ratio to strengths that can't be negative (G. Feldman,
    R. Cousins, Phys. Rev. D 57 (1998)), so that one rule gives a bound where a noise isn't seen and
    two ends where it is. `benchmarks/allan_coverage.py` measures what they cover: a noise that only
    a few low frequencies show, and a ramp beside such a noise, are covered less often than 95 %.

    Args:
        angle: (n,) rad, evenly spaced, without gaps; anything that is no noise taken out, but
            for a constant rate.
        interval: between angles, s.

    Raises:
        NoiseError: fewer than 256 angles, one that is not finite, no noise at all, or an interval
            that is not positive.
    """
    check_record(angle, interval)
    record = spectrum(np.asarray(angle, dtype=np.float64))
    best = fit(record)
    units = [interval ** ((1 - max(power, 1)) / 2) for power in POWERS]
    noises = [_scaled(_strength(record, best, i), unit) for i, unit in enumerate(units)]
    white, walk, flicker, rate_walk = noises
    ramp = _scaled(_ramp(record, best), interval**-2)
    return NoiseCoefficients(white, walk, flicker, rate_walk, ramp)


def check_record(angle: Array, interval: float) -> None:
    """Raise `NoiseError` for a record that `identify` or `allan_deviation` can't use."""
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
    record: Spectrum, held: int | None = None, strength: float = 0.0, start: Array | None = None
) -> Array:
    """Strengths of greatest restricted likelihood, none of them negative.

    Args:
        record: of the angles.
        held: index of a noise whose strength is given.
        strength: that strength, rad^2.
        start: (4,) strengths to begin at; otherwise the largest that nowhere exceed the record.

    Returns:
        (4,) variances, rad^2, in the order of `noise_likelihood.POWERS`.

    Raises:
        NoiseError: the angles have no noise that could be told from rounding.
    """
    free = [i for i in range(len(POWERS)) if i != held]
    largest = np.min(record.power / record.count / record.shapes, axis=1)
    point = np.array(largest if start is None else start)
    if held is not None:
        point[held] = strength
    here = misfit(record, point)
    for _ in range(ITERATIONS):
        goal = _least(here, free, point)
        there = misfit(record, goal)
        for _ in range(HALVINGS):
            if there.value <= here.value:
                break
            goal = (point + goal) / 2
            there = misfit(record, goal)
        if here.value - there.value < SETTLED:
            return point
        point, here = goal, there
    raise NoiseError(f"the noise model has not settled in {ITERATIONS} iterations")


def _least(model: Misfit, free: list[int], point: Array) -> Array:
    """Where the quadratic model is least, over free strengths that are not negative."""
    goal = point.copy()
    held = [i for i in range(len(point)) if i not in free]
    pull = model.pull[free] - model.information[np.ix_(free, held)] @ point[held]
    unit = 1 / np.sqrt(np.diag(model.information)[free])
    root = np.linalg.cholesky(model.information[np.ix_(free, free)] * np.outer(unit, unit))
    goal[free] = unit * nnls(root.T, np.linalg.solve(root, unit * pull))[0]
    return goal


def _strength(record: Spectrum, best: Array, index: int) -> tuple[float, float, float]:
    """Square root of one strength, and its interval, rad."""
    least = misfit(record, best).value
    tiny = 1e-6 * np.min(record.power / record.count / record.shapes, axis=1)

    def excess(root: float) -> float:
        point = fit(record, index, root**2, best + tiny)
        here = misfit(record, point)
        return here.value - least - critical_ratio(root**2 / _deviation(here, index))

    value = math.sqrt(best[index])
    spread = QUANTILE * _deviation(misfit(record, best), index)
    step = math.sqrt(best[index] + spread) - value
    low = 0.0 if excess(0.0) <= 0 else _crossing(excess, 0.0, value)
    return value, low, _crossing(excess, value, _beyond(excess, value, step))


def _deviation(model: Misfit, index: int) -> float:
    """Standard deviation of a strength while the others are fitted, rad^2."""
    return float(math.sqrt(2 * np.linalg.inv(model.information)[index, index]))


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


def _ramp(record: Spectrum, best: Array) -> tuple[float, float, float]:
    """Rate ramp and its interval, rad per square of a sample."""
    here = misfit(record, best)
    unit = np.array([_deviation(here, i) for i in range(len(POWERS))])
    centre, deviation = ramp_estimate(record, best)

    def profile(ramp: float) -> float:
        def value(scaled: Array) -> float:
            return ramp_misfit(record, scaled * unit, ramp)

        start = np.maximum(best / unit, 0.01)
        return float(minimize(value, start, bounds=[(0, None)] * len(POWERS)).fun)

    least = profile(centre)

    def excess(ramp: float) -> float:
        return profile(ramp) - least - QUANTILE**2

    ends = [
        _crossing(excess, centre, _beyond(excess, centre, sign * QUANTILE * deviation))
        for sign in (-1, 1)
    ]
    return tuple(record.ramp + x for x in (centre, *ends))  # type: ignore[return-value]


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
