"""Jumps that stand out of what is left of an output angle."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.effects.jump import Jump, after, jump
from pyhrg.gap.evidence.evidence import log_evidence
from pyhrg.gap.evidence.residuals import Remainder
from pyhrg.gap.whitening.whitening import whitened

Array = NDArray[np.float64]

JUMP_ODDS = 0.025
"""Prior odds that the bias jumps."""
MOMENTS = 24
"""Of a test that are looked at first, and then between the neighbours of the best."""
LOOKED_AT = math.log(2 * MOMENTS)


@dataclass(frozen=True)
class _Seen:
    """The likeliest jump of a test.

    log_odds: that it is there rather than not.
    """

    test: str
    time: float
    log_odds: float


def jumps(remainders: Sequence[Remainder]) -> list[Jump]:
    """The likeliest, and all that are likelier than not together, if that is likely.

    Args:
        remainders: of the output angle, all tests.
    """
    telling = [r for r in remainders if len(r.values) > 2 * MOMENTS]
    each = sorted(map(_likeliest, telling), key=lambda seen: -seen.log_odds)
    likely = [one for one in each if one.log_odds > 0]
    choices = [(likely[:1], len(telling)), (likely, 1)][: len(likely)]
    found = []
    for those, among in choices:
        prior = math.log(JUMP_ODDS / 2 / among)
        if prior + sum(one.log_odds for one in those) > 0:
            times = [(one.test, one.time) for one in those]
            found.append(jump(times, prior - len(those) * LOOKED_AT))
    return found


def _likeliest(r: Remainder) -> _Seen:
    times = _between(r.times[0], r.times[-1])
    best = times[np.argmax(_powers(r, times))]
    step = times[1] - times[0]
    times = _between(best - step, best + step)
    powers = _powers(r, times)
    score = float(log_evidence(powers, 1).max()) - LOOKED_AT
    return _Seen(r.test, float(times[np.argmax(powers)]), score)


def _between(begin: float, end: float) -> Array:
    return np.linspace(begin, end, MOMENTS + 2)[1:-1]


def _powers(r: Remainder, times: Array) -> Array:
    """(k,) that a jump at each time explains, in deviations of the noise squared."""
    white = whitened(after(r.times, times), r.steps, r.noise).series
    lengths = (white**2).sum(axis=0)
    pull = r.white @ white
    return np.divide(pull**2, lengths, out=np.zeros_like(pull), where=lengths > 0)
