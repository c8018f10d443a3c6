"""Steps of the output angle that stand out of what is left of it."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.signal import fftconvolve

from pyhrg.gap.effects.jump import Jump, Kind, since, step
from pyhrg.gap.evidence.evidence import log_evidence
from pyhrg.gap.evidence.residuals import Remainder
from pyhrg.gap.whitening.whitening import whitened

Array = NDArray[np.float64]

KINDS: tuple[Kind, ...] = ("pattern", "output")
STEP_ODDS = 0.025
"""Steps that are expected in a campaign."""
MOST = 5
"""Steps of a campaign; more are noise."""
LEAST_ROWS = 20
"""Of a test that is looked at."""
NEAR = np.arange(-1, 2)
"""Rows beside the likeliest by a common shape, which are looked at by their own."""


@dataclass(frozen=True)
class _Seen:
    """A step, and the power that it explains."""

    test: str
    time: float
    power: float


def steps(remainders: Sequence[Remainder]) -> list[Jump]:
    """The steps that are likelier than not, the greatest alone, with the next, and so on: of the
    pattern, or of the output; none where they are many.

    Args:
        remainders: of the output angle, all tests.
    """
    telling = [r for r in remainders if len(r.values) > LEAST_ROWS]
    rows = sum(len(r.values) for r in telling)
    if not rows:
        return []
    prior = math.log(STEP_ODDS / rows)
    found = [seen for r in telling for seen in _standing_out(r, prior)]
    if not 0 < len(found) <= MOST:
        return []
    found.sort(key=lambda one: -one.power)
    return [
        step(sorted((one.test, one.time) for one in found[:count]), count * prior, kind)
        for count in range(1, len(found) + 1)
        for kind in KINDS
    ]


def _standing_out(r: Remainder, prior: float) -> Iterator[_Seen]:
    """Steps of a test one after the other, the greatest first, each beside those before."""
    white, taken = r.white.copy(), np.empty((len(r.white), 0))
    for _ in range(MOST + 1):
        at = int(np.argmax(_roughly(r, white)))
        near = np.clip(at + NEAR, 0, len(white) - 1)
        columns = whitened(since(r.times, r.times[near]), r.steps, r.noise).series
        columns = columns - taken @ (taken.T @ columns)
        lengths = np.sqrt((columns**2).sum(axis=0))
        units = np.divide(columns, lengths, out=np.zeros_like(columns), where=lengths > 0)
        powers = (white @ units) ** 2
        best = int(np.argmax(powers))
        if prior + float(log_evidence(powers, 1)[best]) <= 0:
            return
        yield _Seen(r.test, float(r.times[near[best]]), float(powers[best]))
        taken = np.column_stack([taken, units[:, best]])
        white = white - units[:, best] * (white @ units[:, best])


def _roughly(r: Remainder, white: Array) -> Array:
    """(n,) power that a step at each row explains, were its shape that of one in the middle."""
    n = len(white)
    middle = n // 2
    begun = whitened(since(r.times, r.times[[middle]]), r.steps, r.noise).series[middle:, 0]
    shape = np.append(begun, np.full(middle, begun[-1]))
    pull = fftconvolve(white, shape[::-1])[n - 1 :]
    return np.asarray(pull**2 / np.cumsum(shape**2)[::-1])
