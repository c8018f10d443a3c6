"""Jumps of the bias and steps of the angle that stand out of the residual of an output angle."""

import math
from collections.abc import Iterator, Sequence

import numpy as np
from scipy.signal import fftconvolve

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.jump import (
    Jump,
    Kind,
    evaluate_step,
    integrate_jump,
    make_bias_jump,
    make_step,
)
from pyhrg.gap.evidence.evidence import HALF_UNNAMED_ODDS, compute_log_evidence
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.whitening.whitening import whiten

MOMENTS = 24
"""Number of moments of a test that are tried first, and again between the neighbours of the best.
Chosen."""
LOG_TRIALS = math.log(2 * MOMENTS)
"""Logarithm of the number of moments that were tried: each has its share of the prior."""
STEP_KINDS: tuple[Kind, ...] = ("pattern", "output")
MAX_STEPS = 5
"""More steps in one campaign are read as noise. Chosen."""
MIN_ROWS = 20
"""Rows that a test must have for steps to be looked for. Chosen."""
NEIGHBOURS = np.arange(-1, 2)
"""Rows around the best approximate one for which the exact response is computed."""


def find_jumps(residuals: Sequence[Residual]) -> list[Jump]:
    """Up to two candidates: a jump in the most probable test alone, and jumps in all tests in which
    a jump is more probable than not (docs/methods/evidence.md, Eq. (14)). Residuals are those of
    the output angle in each test."""
    long = [r for r in residuals if len(r.values) > 2 * MOMENTS]
    by_test = sorted(map(_find_most_probable, long), key=lambda jump: -jump[0])
    probable = [jump for jump in by_test if jump[0] > 0]
    choices = [(probable[:1], len(long)), (probable, 1)][: len(probable)]
    candidates = []
    for jumps, alternatives in choices:
        prior = math.log(HALF_UNNAMED_ODDS / 2 / alternatives)
        if prior + sum(log_odds for log_odds, _, _ in jumps) > 0:
            times = [(test, time) for _, test, time in jumps]
            candidates.append(make_bias_jump(times, prior - len(jumps) * LOG_TRIALS))
    return candidates


def _find_most_probable(r: Residual) -> tuple[float, str, float]:
    """Log odds that a test has a jump, the test, and the most probable time, s."""
    times = _place_moments(r.times[0], r.times[-1])
    best = times[np.argmax(_compute_powers(r, times))]
    step = times[1] - times[0]
    times = _place_moments(best - step, best + step)
    powers = _compute_powers(r, times)
    log_odds = float(compute_log_evidence(powers, 1).max()) - LOG_TRIALS
    return log_odds, r.test, float(times[np.argmax(powers)])


def _place_moments(begin: float, end: float) -> Array:
    return np.linspace(begin, end, MOMENTS + 2)[1:-1]


def _compute_powers(r: Residual, times: Array) -> Array:
    """(k,) decrease of chi-square by a jump at each time."""
    white = whiten(integrate_jump(r.times, times), r.steps, r.noise).series
    information = (white**2).sum(axis=0)
    projection = r.white @ white
    return np.divide(
        projection**2, information, out=np.zeros_like(projection), where=information > 0
    )


def find_steps(residuals: Sequence[Residual], quantum: float = 0.0) -> list[Jump]:
    """Candidates: the greatest step alone, the two greatest, and so on, each as steps of the
    pattern and as steps of the output alone (docs/methods/evidence.md, Eq. (15)).

    Only steps that are more probable than not, and higher than the quantization step of the output,
    count: the error of quantization itself steps where the angle moves by almost a whole number of
    quanta a row. There are no candidates where there are more than `MAX_STEPS` of them.

    Args:
        residuals: of the output angle in each test.
        quantum: quantization step of the output, rad; 0 for none.
    """
    long = [r for r in residuals if len(r.values) > MIN_ROWS]
    rows = sum(len(r.values) for r in long)
    if not rows:
        return []
    prior = math.log(HALF_UNNAMED_ODDS / rows)
    steps = [step for r in long for step in _pursue_steps(r, prior, quantum)]
    if not 0 < len(steps) <= MAX_STEPS:
        return []
    steps.sort(key=lambda step: -step[0])
    return [
        make_step(sorted((test, time) for _, test, time in steps[:count]), count * prior, kind)
        for count in range(1, len(steps) + 1)
        for kind in STEP_KINDS
    ]


def _pursue_steps(r: Residual, prior: float, quantum: float) -> Iterator[tuple[float, str, float]]:
    """Steps of a test by orthogonal matching pursuit, the greatest first, as long as they are
    higher than a quantum: decrease of chi-square, test, and time, s."""
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
        is_probable = prior + float(compute_log_evidence(powers, 1)[best]) > 0
        if not is_probable or abs(white @ units[:, best]) <= quantum * norms[best]:
            return
        yield float(powers[best]), r.test, float(r.times[rows[best]])
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
