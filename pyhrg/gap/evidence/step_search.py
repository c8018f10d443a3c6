"""Steps of the output angle that stand out of its residual."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import fftconvolve

from pyhrg.gap.effects.jump import Jump, Kind, evaluate_step, make_step
from pyhrg.gap.evidence.evidence import log_evidence
from pyhrg.gap.evidence.prior_odds import HALF_UNNAMED_ODDS
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import whiten

Array = NDArray[np.float64]

KINDS: tuple[Kind, ...] = ("pattern", "output")
MAX_STEPS = 5
"""More steps in one campaign are read as noise. Chosen."""
MIN_ROWS = 20
"""Rows that a test must have for steps to be looked for. Chosen."""
NEIGHBOURS = np.arange(-1, 2)
"""Rows around the best approximate one for which the exact response is computed."""


@dataclass(frozen=True)
class _Step:
    """A step at a time, and the decrease of chi-square by it."""

    test: str
    time: float
    power: float


def find_steps(residuals: Sequence[Residual]) -> list[Jump]:
    """Candidates: the greatest step alone, the two greatest, and so on, each as steps of the
    pattern and as steps of the output alone (docs/methods/evidence.md, Eq. (15)).

    Only steps that are more probable than not count. There are no candidates where there are more
    than `MAX_STEPS` of them.

    Args:
        residuals: residual of the output angle in each test.
    """
    long = [r for r in residuals if len(r.values) > MIN_ROWS]
    rows = sum(len(r.values) for r in long)
    if not rows:
        return []
    prior = math.log(HALF_UNNAMED_ODDS / rows)
    steps = [step for r in long for step in _pursue_steps(r, prior)]
    if not 0 < len(steps) <= MAX_STEPS:
        return []
    steps.sort(key=lambda step: -step.power)
    return [
        make_step(sorted((step.test, step.time) for step in steps[:count]), count * prior, kind)
        for count in range(1, len(steps) + 1)
        for kind in KINDS
    ]


def _pursue_steps(r: Residual, prior: float) -> Iterator[_Step]:
    """Steps of a test by orthogonal matching pursuit, the greatest first."""
    white, removed = r.white.copy(), np.empty((len(r.white), 0))
    for _ in range(MAX_STEPS + 1):
        best_row = int(np.argmax(_approximate_powers(r, white)))
        rows = np.clip(best_row + NEIGHBOURS, 0, len(white) - 1)
        columns = whiten(evaluate_step(r.times, r.times[rows]), r.steps, r.noise).series
        columns = columns - removed @ (removed.T @ columns)
        norms = np.sqrt((columns**2).sum(axis=0))
        units = np.divide(columns, norms, out=np.zeros_like(columns), where=norms > 0)
        powers = (white @ units) ** 2
        best = int(np.argmax(powers))
        if prior + float(log_evidence(powers, 1)[best]) <= 0:
            return
        yield _Step(r.test, float(r.times[rows[best]]), float(powers[best]))
        removed = np.column_stack([removed, units[:, best]])
        white = white - units[:, best] * (white @ units[:, best])


def _approximate_powers(r: Residual, white: Array) -> Array:
    """(n,) decrease of chi-square by a step at each row, if every step had the whitened shape of
    the one in the middle of the test."""
    n = len(white)
    middle = n // 2
    tail = whiten(evaluate_step(r.times, r.times[[middle]]), r.steps, r.noise).series[middle:, 0]
    shape = np.append(tail, np.full(middle, tail[-1]))
    projection = fftconvolve(white, shape[::-1])[n - 1 :]
    return np.asarray(projection**2 / np.cumsum(shape**2)[::-1])
