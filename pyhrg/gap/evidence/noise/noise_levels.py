"""How likely records are at levels of the output angle's noise, and the level that is likeliest."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize_scalar

from pyhrg.gap.whitening.whitening import SlowNoise, whitened

Array = NDArray[np.float64]

PARTS = {
    "angle_random_walk": "walk",
    "rate_random_walk": "rate_walk",
    "bias_instability": "flicker",
    "pickoff_noise": "white",
}
"""Part of `SlowNoise` by field of a device."""
RANGE = (1e-3, 1e3)
"""Levels of an added noise over its usual size; flat in the logarithm between them."""
SAME_LEVEL = 0.02
"""Share by which two levels differ that are one."""
GRID = 13
"""Levels that are looked at over the range before the likeliest is found."""
FINELY = 0.01
"""To which its logarithm is found."""
CURVATURE = 0.1
"""Step of the logarithm by which the likelihood's curvature is taken."""


@dataclass(frozen=True)
class AngleRecord:
    """What is left of an output angle when all that is explained is taken out.

    angle: (n,) rad.
    steps: (n,) time from the reading before, s.
    encoder: white noise that is none of the gyro's, rad.
    """

    angle: Array
    steps: Array
    encoder: float = 0.0


def alike(one: SlowNoise, other: SlowNoise) -> bool:
    """Whether levels differ by less than what can be told."""
    pairs = [(getattr(one, part), getattr(other, part)) for part in PARTS.values()]
    if one.correlated and other.correlated:
        pairs.append((one.correlated.level, other.correlated.level))
    kinds = [noise.correlated and noise.correlated.kind for noise in (one, other)]
    return kinds[0] == kinds[1] and all(abs(a - b) <= SAME_LEVEL * max(a, b) for a, b in pairs)


def log_likelihood(records: Sequence[AngleRecord], noise: SlowNoise) -> float:
    """Of records under a noise, but for a constant."""
    total = 0.0
    for record in records:
        white = whitened(record.angle[:, None], record.steps, noise.louder(record.encoder))
        total -= (float((white.series**2).sum()) + white.log_determinant) / 2
    return total


@dataclass(frozen=True)
class Level:
    """The likeliest level of an added noise.

    logarithm: of it.
    gain: there, of the logarithm of likelihood and other priors.
    deviation: of the logarithm.
    """

    logarithm: float
    gain: float
    deviation: float

    def log_prior(self, odds: float) -> float:
        """Of a noise of these prior odds, its level integrated out (Laplace)."""
        width = math.log(RANGE[1] / RANGE[0])
        return math.log(odds * self.deviation * math.sqrt(2 * math.pi) / width)


def level_found(gain: Callable[[float], float], scale: float) -> Level:
    """The likeliest level.

    Args:
        gain: by the level's logarithm.
        scale: a level that is nothing special.
    """
    low, high = (math.log(scale * end) for end in RANGE)
    grid = np.linspace(low, high, GRID)
    values = [gain(x) for x in grid]
    top = int(np.argmax(values))
    bounds = (grid[max(top - 1, 0)], grid[min(top + 1, len(grid) - 1)])
    best = float(minimize_scalar(lambda x: -gain(x), bounds=bounds, options={"xatol": FINELY}).x)
    peak = gain(best)
    curvature = -(gain(best + CURVATURE) - 2 * peak + gain(best - CURVATURE)) / CURVATURE**2
    return Level(best, peak, 1 / math.sqrt(max(curvature, 1 / (high - low) ** 2)))
