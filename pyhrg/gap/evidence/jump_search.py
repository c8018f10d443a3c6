"""Jumps of the bias that stand out of the residual of an output angle."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.effects.jump import Jump, integrate_jump, make_bias_jump
from pyhrg.gap.evidence.evidence import log_evidence
from pyhrg.gap.evidence.prior_odds import HALF_UNNAMED_ODDS
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import whiten

Array = NDArray[np.float64]

MOMENTS = 24
"""Number of moments of a test that are tried first, and again between the neighbours of the best.
Chosen."""
LOG_TRIALS = math.log(2 * MOMENTS)
"""Logarithm of the number of moments that were tried: each has its share of the prior."""


@dataclass(frozen=True)
class _TestJump:
    """The most probable jump of a test, and the log odds that it is there."""

    test: str
    time: float
    log_odds: float


def find_jumps(residuals: Sequence[Residual]) -> list[Jump]:
    """Up to two candidates: a jump in the most probable test alone, and jumps in all tests in which
    a jump is more probable than not (docs/methods/evidence.md, Eq. (14)).

    Args:
        residuals: residual of the output angle in each test.
    """
    long = [r for r in residuals if len(r.values) > 2 * MOMENTS]
    by_test = sorted(map(_most_probable, long), key=lambda jump: -jump.log_odds)
    probable = [jump for jump in by_test if jump.log_odds > 0]
    choices = [(probable[:1], len(long)), (probable, 1)][: len(probable)]
    candidates = []
    for jumps, alternatives in choices:
        prior = math.log(HALF_UNNAMED_ODDS / 2 / alternatives)
        if prior + sum(jump.log_odds for jump in jumps) > 0:
            times = [(jump.test, jump.time) for jump in jumps]
            candidates.append(make_bias_jump(times, prior - len(jumps) * LOG_TRIALS))
    return candidates


def _most_probable(r: Residual) -> _TestJump:
    times = _moments(r.times[0], r.times[-1])
    best = times[np.argmax(_powers(r, times))]
    step = times[1] - times[0]
    times = _moments(best - step, best + step)
    powers = _powers(r, times)
    log_odds = float(log_evidence(powers, 1).max()) - LOG_TRIALS
    return _TestJump(r.test, float(times[np.argmax(powers)]), log_odds)


def _moments(begin: float, end: float) -> Array:
    return np.linspace(begin, end, MOMENTS + 2)[1:-1]


def _powers(r: Residual, times: Array) -> Array:
    """(k,) decrease of chi-square by a jump at each time."""
    white = whiten(integrate_jump(r.times, times), r.steps, r.noise).series
    information = (white**2).sum(axis=0)
    projection = r.white @ white
    return np.divide(
        projection**2, information, out=np.zeros_like(projection), where=information > 0
    )
