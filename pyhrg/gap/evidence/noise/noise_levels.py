"""Likelihood of the output angle's residuals at given noise levels, and the most probable level."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache, partial

import numpy as np
from scipy.optimize import minimize_scalar

from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import NoiseModel, whiten
from pyhrg.noise.coefficients import COEFFICIENT_NAMES

Likelihood = Callable[[NoiseModel], float]
"""Log likelihood by the noise, up to a constant."""

LEVEL_RANGE = (1e-3, 1e3)
"""Range of an added noise's level over its typical one; its prior is flat in the logarithm between.
Chosen."""
LEVEL_TOLERANCE = 0.02
"""Two levels are equal when they differ by less than this share. Chosen: well below the 3 % to
which a stated level is known."""
GRID_LEVELS = 13
"""Levels over the range that are tried before the maximum is refined: two per decade. Chosen."""
MAX_DROP = 50.0
"""Fall of the log density below its largest value at which no higher level is tried. Chosen: by
then it falls with the logarithm of the level, once for each row."""
LEVEL_PRECISION = 0.01
"""Precision of the logarithm of the most probable level. Chosen."""
CURVATURE_STEP = 0.1
"""Step of the level's logarithm in the second difference that gives the curvature. Chosen."""


def are_equal(noise: NoiseModel, other: NoiseModel) -> bool:
    """Whether two noises have the same parts at levels that differ by less than the tolerance."""
    pairs = [(getattr(noise, part), getattr(other, part)) for part in COEFFICIENT_NAMES]
    kinds = [[each.kind for each in n.correlated] for n in (noise, other)]
    lasting = zip(noise.correlated, other.correlated, strict=False)
    pairs += [(own.level, its.level) for own, its in lasting]
    return kinds[0] == kinds[1] and all(abs(a - b) <= LEVEL_TOLERANCE * max(a, b) for a, b in pairs)


def build_likelihood(residuals: Sequence[Residual]) -> Likelihood:
    """Log likelihood of these residuals; searches ask for it again at the same levels."""
    return cache(partial(compute_log_likelihood, residuals))


def compute_log_likelihood(residuals: Sequence[Residual], noise: NoiseModel) -> float:
    """Log likelihood of residuals of the output angle under a noise, up to a constant."""
    total = 0.0
    for residual in residuals:
        own = noise.as_in(residual.noise)
        white = whiten(residual.values[:, None], residual.steps, own, residual.unmodelled)
        deviance = float((white.series**2).sum()) + white.log_determinant
        total -= deviance / 2 / (1 + residual.model_error)
    return total


@dataclass(frozen=True)
class Level:
    """The most probable level of an added noise.

    logarithm: logarithm of the level.
    gain: gain in log posterior density at this level.
    sigma: standard deviation of the logarithm.
    """

    logarithm: float
    gain: float
    sigma: float

    def log_prior(self, odds: float) -> float:
        """What prior odds and Laplace's integral over the level add to the log odds of the noise
        (docs/methods/evidence.md, Eq. (12))."""
        width = math.log(LEVEL_RANGE[1] / LEVEL_RANGE[0])
        return math.log(odds * self.sigma * math.sqrt(2 * math.pi) / width)


def fit_level(gain: Callable[[float], float], scale: float) -> Level:
    """Find the most probable level about a typical one, from the gain in log posterior density by
    the level's logarithm."""
    low, high = (math.log(scale * end) for end in LEVEL_RANGE)
    grid = np.linspace(low, high, GRID_LEVELS)
    values: list[float] = []
    for x in grid:
        values.append(gain(x))
        if values[-1] < max(values) - MAX_DROP:
            break
    top = int(np.argmax(values))
    if top == 0:  # the less of it the better
        return Level(low, values[0], high - low)
    bounds = (grid[top - 1], grid[min(top + 1, len(grid) - 1)])
    options = {"xatol": LEVEL_PRECISION}
    best = float(minimize_scalar(lambda x: -gain(x), bounds=bounds, options=options).x)
    peak = gain(best)
    second = gain(best + CURVATURE_STEP) - 2 * peak + gain(best - CURVATURE_STEP)
    curvature = -second / CURVATURE_STEP**2
    return Level(best, peak, 1 / math.sqrt(max(curvature, 1 / (high - low) ** 2)))
