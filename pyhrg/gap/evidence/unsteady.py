"""What is left when all that has a name is taken out, and is no steady noise: a line, or a stretch
of a test whose noise is another. No coordinate of a test foretells either.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import groupby

import numpy as np
from numpy.typing import NDArray
from scipy.special import expit, logsumexp

from pyhrg.gap.effects.design import Where
from pyhrg.gap.evidence.evidence import log_evidence
from pyhrg.gap.evidence.residuals import Remainder

Array = NDArray[np.float64]

ODDS = 0.025
"""Prior odds of a line, and of a stretch."""
SHORTEST = 16
"""Readings of a stretch."""
BLOCKS = (1, 8, 64)
"""Rows that add up to a reading: over more of them, noise that wanders stands out."""
LOUDEST = 10.0
"""Noise of a stretch over that of its test, or the other way round."""
GAUSSIAN = 2.0
"""Variance of squares of normal numbers; of noise with heavier tails they scatter more."""
TOLERANCE = 0.03
"""By which noise may be steady and its level off, of its logarithm."""
CYCLES = 5
"""In the longest test, of what is a line and no drift."""
PADDING = 2
"""Frequencies in the width of a line."""


@dataclass(frozen=True)
class Unsteady:
    """What a remainder may be beside steady noise.

    words: what and where, for people.
    log_odds: that it is there.
    """

    words: str
    log_odds: float

    @property
    def probability(self) -> float:
        """That it is there."""
        return float(expit(self.log_odds))


def unsteady(
    remainders: Sequence[Remainder], wrong: Mapping[Where, float] | None = None
) -> tuple[Unsteady, ...]:
    """The likeliest line and the likeliest stretch, each by itself, there or not.

    Args:
        remainders: of all tests and channels; those of a few rows, or without any noise, say
            nothing.
        wrong: power that the simulation may get wrong, in deviations of the noise squared.
    """
    wrong = wrong or {}
    telling = [r for r in remainders if len(r.values) >= 2 * SHORTEST and r.values.any()]
    alternatives = [list(_lines(telling, wrong)), list(_stretches(telling, wrong))]
    return tuple(_likeliest(found) for found in alternatives if found)


def _likeliest(alternatives: Sequence[Unsteady]) -> Unsteady:
    """One of several that are as likely beforehand: its words, the odds of all."""
    best = max(alternatives, key=lambda one: one.log_odds)
    every = float(logsumexp([one.log_odds for one in alternatives]))
    return Unsteady(best.words, every - math.log(len(alternatives)) + math.log(ODDS))


def _lines(remainders: Sequence[Remainder], wrong: Mapping[Where, float]) -> Iterator[Unsteady]:
    """A frequency of a channel, in one test alone or in all tests of one row length."""
    kinds = sorted(remainders, key=lambda r: (r.channel, r.interval))
    for (channel, interval), group in groupby(kinds, key=lambda r: (r.channel, r.interval)):
        those = list(group)
        rows = [np.round(r.times / interval).astype(int) for r in those]
        spans = [int(row[-1]) + 1 for row in rows]
        size = 1 << math.ceil(math.log2(PADDING * max(spans)))
        slowest = [math.ceil(CYCLES * size / span) for span in spans]
        powers = [
            _spectrum(r, own, first, size) / (1 + wrong.get((r.test, channel), 0.0))
            for r, own, first in zip(those, rows, slowest, strict=True)
        ]
        sets = [([k], power) for k, power in enumerate(powers)]
        if len(those) > 1:
            sets.append((list(range(len(those))), np.sum(powers, axis=0)))
        for tests, power in sets:
            first = min(slowest[k] for k in tests)
            score = log_evidence(power[first:-1], 2 * len(tests))
            period = size * interval / (first + int(np.argmax(score)))
            where = those[tests[0]].test if len(tests) == 1 else f"{len(tests)} tests"
            yield Unsteady(
                f"periodic in {period:.4g} s in {where} ({channel})",
                float(logsumexp(score)) - math.log(len(score)),
            )


def _spectrum(r: Remainder, rows: NDArray[np.int64], slowest: int, size: int) -> Array:
    """(size / 2 + 1,) power that a line of each frequency explains, in deviations of the noise that
    there is; none below the slowest."""
    series = np.zeros(size)
    series[rows] = r.white
    level = max(float(np.mean(r.white**2)), 1.0)
    power = 2 * np.abs(np.fft.rfft(series)) ** 2 / (len(rows) * level)
    power[:slowest] = 0.0
    return np.asarray(power)


def _stretches(remainders: Sequence[Remainder], wrong: Mapping[Where, float]) -> Iterator[Unsteady]:
    """Halves of a test, quarters, and so on, each beside the level of the whole test."""
    for r in remainders:
        own = 1 + wrong.get((r.test, r.channel), 0.0)
        for rows in BLOCKS:
            count = len(r.white) // rows
            if count < 2 * SHORTEST:
                break
            readings = r.white[: count * rows].reshape(count, rows).sum(axis=1)
            squares = readings**2 / np.mean(readings**2)
            worth = GAUSSIAN / max(float(np.var(squares)), GAUSSIAN) / own
            summed = np.concatenate([[0.0], np.cumsum(squares)])
            length = count // 2
            while length >= SHORTEST:
                begins = np.arange(0, count - length + 1, length // 2)
                level = (summed[begins + length] - summed[begins]) / length
                score = _another_level(level, length, worth)
                first = r.times[begins[int(np.argmax(score))] * rows]
                yield Unsteady(
                    f"noise of its own in {r.test} from {first:.0f} s ({r.channel})",
                    float(logsumexp(score)) - math.log(len(score)),
                )
                length //= 2


def _another_level(level: Array, readings: int, worth: float) -> Array:
    """Log evidence that noise of a mean square has a level of its own, flat in its logarithm.

    Args:
        level: mean square over a stretch, over that of its test.
        readings: of a stretch.
        worth: share of a Gaussian reading's information that one of these has.
    """
    off = np.log(level) / 2
    off = np.sign(off) * np.maximum(np.abs(off) - TOLERANCE, 0.0)
    n = readings * worth
    likelier = n / 2 * (np.exp(2 * off) - 1 - 2 * off)
    return np.asarray(likelier + math.log(math.pi / n) / 2 - math.log(2 * math.log(LOUDEST)))
