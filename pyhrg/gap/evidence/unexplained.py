"""What no set explains: a residual far above its noise.

Physics that neither effects nor candidate terms hold leaves such a residual, and a swarm of them
imitates it. What a hypothesis leaves of it counts against all (docs/methods/evidence.md, Eq. 10d).
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import groupby

import numpy as np
from scipy.stats import chi2

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.design import TestChannel
from pyhrg.gap.evidence.residuals import Residual
from pyhrg.gap.replay.observations import ObservedTest

CERTAIN_CHI2 = 30.0
"""Excess over the number of rows, as chi-square, that steady noise does not have. Chosen."""
QUIETEST_QUANTILE = 1e-4
"""Quantile of chi-square that the quietest of some tests exceeds. Chosen."""
MIN_GROWTH_RATIO = 1.1
"""Ratio to the unexplained chi-square counted so far above which it is counted anew. Chosen."""


def find_excesses(residuals: Sequence[Residual]) -> Iterator[tuple[Residual, float]]:
    """Residuals that are more than noise, with their chi-square beyond it: more than that of the
    noise itself.

    A noise that is louder than stated is so in all tests of a channel: there the highest level that
    the quietest test may have is the measure of all.
    """
    order = sorted((r for r in residuals if len(r.values)), key=lambda r: r.channel)
    for _, group in groupby(order, key=lambda r: r.channel):
        own = list(group)
        powers = np.array([residual.white @ residual.white for residual in own])
        rows = np.array([len(residual.white) for residual in own])
        level = max(1.0, float((powers / chi2.ppf(QUIETEST_QUANTILE, rows)).min()))
        for residual, excess in zip(own, (powers / level - rows).tolist(), strict=True):
            if excess > len(residual.white) + CERTAIN_CHI2:
                yield residual, excess


def measure_unexplained(residuals: Sequence[Residual]) -> dict[TestChannel, float]:
    """Chi-square for each independent component of the residuals that are more than noise."""
    return {
        (residual.test, residual.channel): excess / _count_components(residual.white)
        for residual, excess in find_excesses(residuals)
    }


def count_unexplained(
    tests: Sequence[ObservedTest], powers: Mapping[TestChannel, float]
) -> list[ObservedTest] | None:
    """The tests, each with the largest unexplained chi-square of each channel so far; None where
    these powers are nowhere larger than known before."""
    known = {(t.test.id, channel): power for t in tests for channel, power in t.unexplained.items()}
    if all(power <= MIN_GROWTH_RATIO * known.get(where, 0.0) for where, power in powers.items()):
        return None
    largest = {w: max(powers.get(w, 0.0), known.get(w, 0.0)) for w in {**known, **powers}}

    def select(test: ObservedTest) -> dict[str, float]:
        return {c: power for (name, c), power in largest.items() if name == test.test.id}

    return [replace(test, unexplained=select(test)) for test in tests]


def _count_components(white: Array) -> float:
    """Number of independent components of a series: the participation ratio of its spectrum. A
    slow curve has about two, white noise half as many as it has rows."""
    power = np.abs(np.fft.rfft(white, 2 * len(white))) ** 2
    return float(power.sum() ** 2 / (power**2).sum())
