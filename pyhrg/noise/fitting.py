"""Noise coefficients of an angle record by restricted maximum likelihood, with intervals."""

import math
from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import brentq, nnls
from scipy.special import ndtr
from scipy.stats import norm

from pyhrg.common.arrays import Array
from pyhrg.noise.coefficients import CONFIDENCE, Coefficient, NoiseCoefficients, NoiseError
from pyhrg.noise.likelihood import (
    POWERS,
    Misfit,
    Spectrum,
    compute_misfit,
    compute_spectrum,
    describe_estimator,
)

MIN_SAMPLES = 256
"""Smallest number of angles in a record. Chosen."""
NORMAL_QUANTILE = float(norm.ppf(0.5 + CONFIDENCE / 2))
"""Half width of a 95 % interval in standard deviations of a normal estimate."""
MAX_ITERATIONS = 1000
"""Largest number of steps of a fit. Chosen."""
RELATIVE_ROUNDING = 1e-14
"""Noise below this share of the largest angle is rounding. Chosen: 45 roundings of a double."""
MAX_HALVINGS = 12
"""Largest number of halvings of a step that raises the misfit. Chosen."""
MAX_DOUBLINGS = 40
"""Largest number of doublings of a step in search of an interval's end. Chosen."""
CONVERGENCE_MISFIT = 1e-5
"""A fit has converged when a step lowers the misfit by less than this. Chosen."""


def estimate_noise(angle: Array, interval: float) -> NoiseCoefficients:
    """Noise coefficients of one record; a constant rate and a rate ramp do not touch them.

    Angles are (n,) rad, evenly spaced, without gaps, and without other signals.
    """
    check_record(angle, interval)
    return fit_coefficients([compute_spectrum(np.asarray(angle, dtype=np.float64))], interval)


def fit_coefficients(records: Sequence[Spectrum], interval: float) -> NoiseCoefficients:
    """Noise coefficients by restricted maximum likelihood, intervals by its profile.

    The 95 % intervals order by the likelihood ratio, with strengths of zero or more (G. Feldman,
    R. Cousins, Phys. Rev. D 57 (1998)). So one rule gives an upper bound where a noise isn't seen
    and two ends where it is. The signed root of the ratio is normal about minus a sixth of the
    estimator's skewness (O. Barndorff-Nielsen, Biometrika 73 (1986)), which matters where a few
    slow frequencies show a noise; it corrects the end of the interval that it moves
    outwards, so that no interval becomes narrower.
    `benchmarks/intervals/noise.py` measures the intervals' coverage.
    """
    best = maximize_likelihood(records)
    units = [interval ** ((1 - max(power, 1)) / 2) for power in POWERS]
    roots = [_estimate_strength(records, best, i) for i in range(len(POWERS))]
    scaled = [[unit * x for x in root] for root, unit in zip(roots, units, strict=True)]
    return NoiseCoefficients(*(Coefficient(*values) for values in scaled))


def check_record(angle: Array, interval: float) -> None:
    """Refuse a record whose noise can't be estimated."""
    if not (math.isfinite(interval) and interval > 0):
        raise NoiseError(f"interval is {interval} s, expected more than 0")
    if np.ndim(angle) != 1 or len(angle) < MIN_SAMPLES:
        found = f"shape {np.shape(angle)}"
        raise NoiseError(f"angles are of {found}, expected ({MIN_SAMPLES} or more,)")
    if not np.all(np.isfinite(angle)):
        first = int(np.argmin(np.isfinite(angle)))
        raise NoiseError(
            f"angle {first} is {angle[first]}, expected a stretch without gaps, in rad"
        )
    line = np.polynomial.Polynomial.fit(np.arange(len(angle)), angle, 2)
    if np.std(angle - line(np.arange(len(angle)))) <= RELATIVE_ROUNDING * np.max(np.abs(angle)):
        raise NoiseError("the angles are a parabola: no noise beyond rounding")


def maximize_likelihood(
    records: Sequence[Spectrum],
    held: int | None = None,
    strength: float = 0.0,
    start: Array | None = None,
) -> Array:
    """Strengths that maximize the restricted likelihood, none of them negative.

    Returns (4,) rad^2, in the order of `pyhrg.noise.likelihood.POWERS`. `held` is the index of a
    noise whose strength is fixed; the fit begins at `start` (4,), else at those of
    `bound_strengths`.
    """
    free = [i for i in range(len(POWERS)) if i != held]
    point = bound_strengths(records) if start is None else np.array(start)
    if held is not None:
        point[held] = strength
    here = compute_misfit(records, point)
    for _ in range(MAX_ITERATIONS):
        goal = _minimize_model(here, free, point)
        there = compute_misfit(records, goal)
        for _ in range(MAX_HALVINGS):
            if there.value <= here.value:
                break
            goal = (point + goal) / 2
            there = compute_misfit(records, goal)
        if here.value - there.value < CONVERGENCE_MISFIT:
            return point
        point, here = goal, there
    raise NoiseError(f"the noise model has not converged in {MAX_ITERATIONS} iterations")


def bound_strengths(records: Sequence[Spectrum]) -> Array:
    """(4,) largest strengths, rad^2, whose density nowhere exceeds that of a record."""
    each = [np.min(r.power / r.bands.count / r.bands.shapes, axis=1) for r in records]
    return np.asarray(np.min(each, axis=0))


def _minimize_model(model: Misfit, free: list[int], point: Array) -> Array:
    """(4,) strengths at the minimum of the quadratic model over the free ones, none negative."""
    goal = point.copy()
    held = [i for i in range(len(point)) if i not in free]
    right_side = model.right_side[free] - model.information[np.ix_(free, held)] @ point[held]
    unit = 1 / np.sqrt(np.diag(model.information)[free])
    root = np.linalg.cholesky(model.information[np.ix_(free, free)] * np.outer(unit, unit))
    goal[free] = unit * nnls(root.T, np.linalg.solve(root, unit * right_side))[0]
    return goal


def _estimate_strength(
    records: Sequence[Spectrum], best: Array, index: int
) -> tuple[float, float, float]:
    """Square root of one strength, and its 95 % interval, rad."""
    lowest = compute_misfit(records, best).value
    value = math.sqrt(best[index])
    tiny = 1e-6 * bound_strengths(records)

    def excess(root: float) -> float:
        point = maximize_likelihood(records, index, root**2, best + tiny)
        here = compute_misfit(records, point)
        deviation, skewness = describe_estimator(records, here, point, index)
        reach = math.sqrt(compute_critical_ratio(root**2 / deviation))
        reach += max(0.0, math.copysign(skewness / 6, root - value))
        return here.value - lowest - reach**2

    spread = (
        NORMAL_QUANTILE * describe_estimator(records, compute_misfit(records, best), best, index)[0]
    )
    step = math.sqrt(best[index] + spread) - value
    low = 0.0 if value == 0 or excess(0.0) <= 0 else _find_crossing(excess, 0.0, value)
    return value, low, _find_crossing(excess, value, _find_outside(excess, value, step))


def compute_critical_ratio(distance: float) -> float:
    """95 % quantile of twice the log likelihood ratio, for a strength that can't be negative.

    The distance is that of the true strength from zero, in standard deviations of its estimate.
    """
    if distance >= NORMAL_QUANTILE:
        return NORMAL_QUANTILE**2
    if distance < 1e-6:
        return float(norm.isf(1 - CONFIDENCE)) ** 2

    def uncovered(ratio: float) -> float:
        below = ndtr(-(distance**2 + ratio) / (2 * distance))
        return float(ndtr(-math.sqrt(ratio)) + below - (1 - CONFIDENCE))

    return float(brentq(uncovered, distance**2, NORMAL_QUANTILE**2))


def _find_outside(excess: Callable[[float], float], inside: float, step: float) -> float:
    """A point outside the interval, on the side of the step."""
    for _ in range(MAX_DOUBLINGS):
        if excess(inside + step) > 0:
            return inside + step
        step *= 2
    raise NoiseError("the record is too short to bound one of its noise coefficients")


def _find_crossing(excess: Callable[[float], float], first: float, last: float) -> float:
    return float(brentq(excess, first, last, xtol=1e-3 * abs(last - first), rtol=1e-3))
