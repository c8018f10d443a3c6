"""Where a gap lies: shares of its power by test, channel and coordinate.

The method is matching pursuit over candidate terms (docs/methods/verdict.md, Eq. (7)).
"""

import math
from collections import defaultdict
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.candidate_terms import CandidateTerm
from pyhrg.gap.effects.coordinates import SETTLING_FACTORS
from pyhrg.gap.effects.design import Block, Design, subtract_sizes
from pyhrg.gap.effects.linear_test import LinearTest

Key = TypeVar("Key", bound=Hashable)
Columns = Mapping[CandidateTerm, NDArray[np.int64]]
"""Columns of each term within a block."""

MIN_POWER = 25.0
"""A coordinate takes part when it explains more power than this: five sigma squared. Chosen."""
MIN_EXCESS_SIGMA = 5.0
"""A test's own excess is placed when it exceeds this many standard deviations of its noise's power.
Chosen."""
UNPLACED_SHARE = 0.01
"""The pursuit ends when less than this share of a channel's excess is left. Chosen."""
POWER_TOLERANCE = 4.0
"""Terms that explain less by up to this power count as equally good; the first in the catalogue is
taken. Chosen: two sigma squared."""


@dataclass(frozen=True)
class Place:
    """A share of the gap.

    share: of the power of the whole gap.
    sigmas: root of its power, in sigma of the noise.
    harmonic: number of the harmonic where the coordinate is an angle that moves by a period of it
        or more in the test; otherwise harmonics are confounded.
    """

    test: str
    channel: str
    coordinate: str
    share: float
    sigmas: float
    harmonic: int | None = None


def sum_shares(places: Sequence[Place], key: Callable[[Place], Key]) -> dict[Key, float]:
    """Shares of the gap by a key of its places; 0 for others."""
    shares: dict[Key, float] = defaultdict(float)
    for place in places:
        shares[key(place)] += place.share
    return shares


def locate_gap(
    design: Design, travels: Mapping[tuple[str, str], float] | None = None
) -> tuple[Place, ...]:
    """Places where the residual has more power than its noise, the largest share first. The design
    is whitened by the stated noise. `travels` are the ranges of angles by test and coordinate, rad;
    without them every harmonic is named.

    Within a channel, candidate terms are fitted and removed one by one: first with the same size in
    all tests, then in each test that has power left. Power that no term explains has the coordinate
    `noise`. Products with a function that settles are left out: they would place in time what the
    pattern angle makes in short tests.
    """
    groups = (g for g in design.columns if isinstance(g, CandidateTerm))
    terms = [term for term in groups if term.second not in SETTLING_FACTORS]
    powers: dict[tuple[str, str, str, int | None], float] = {}
    for channel in dict.fromkeys(block.channel for block in design.blocks):
        blocks = [block for block in design.blocks if block.channel == channel]
        own = [term for term in terms if term.channel == channel]
        columns = {t: np.flatnonzero(np.isin(blocks[0].columns, design.columns[t])) for t in own}
        shared, blocks = _pursue_shared(blocks, columns)
        single = [(block.test, *part) for block in blocks for part in _pursue(block, columns)]
        for test, coordinate, harmonic, power in (*shared, *single):
            angle = (harmonic or 0) * (travels or {}).get((test, coordinate), math.inf)
            is_seen = not harmonic or angle >= 2 * math.pi
            key = (test, channel, coordinate, harmonic if is_seen else None)
            powers[key] = powers.get(key, 0.0) + power
    total = sum(powers.values())
    places = [
        Place(test, channel, coordinate, power / total, float(np.sqrt(power)), harmonic)
        for (test, channel, coordinate, harmonic), power in powers.items()
    ]
    return tuple(sorted(places, key=lambda place: -place.share))


def measure_travels(parts: Sequence[LinearTest]) -> dict[tuple[str, str], float]:
    """Ranges of the angles by test and coordinate, rad."""
    return {
        (part.test.test.id, angle): float(np.ptp(values[np.isfinite(values)]))
        for part in parts
        for angle in ("wave_angle", "table_angle")
        for values in (getattr(part.test.log, angle),)
    }


def _pursue_shared(
    blocks: Sequence[Block], columns: Columns
) -> tuple[list[tuple[str, str, int | None, float]], list[Block]]:
    """Test, coordinate, harmonic and power of terms with the same size in all tests; and the blocks
    with these terms removed."""
    parts = []
    threshold = max(MIN_POWER, UNPLACED_SHARE * sum(_compute_excess(block) for block in blocks))
    candidates = dict(columns)
    while (choice := _choose_term(blocks, candidates, threshold)) is not None:
        best, power, sizes = choice
        where = candidates.pop(best)
        after = [
            replace(block, gram=subtract_sizes(block.gram, where, size))
            for block, size in zip(blocks, sizes, strict=True)
        ]
        gains = [
            max(_compute_excess(b) - _compute_excess(a), 0.0)
            for b, a in zip(blocks, after, strict=True)
        ]
        for block, gain in zip(blocks, gains, strict=True):
            if gain > 0:
                share = gain / sum(gains)
                parts.append((block.test, best.coordinate, best.harmonic, share * power))
        blocks = after
    return parts, list(blocks)


def _choose_term(
    blocks: Sequence[Block], candidates: Columns, threshold: float
) -> tuple[CandidateTerm, float, list[Array]] | None:
    """The term that explains most of all tests, the power that it explains, and its size in each.

    Terms with a size of their own in each power-on are chosen only when no other explains enough.
    """
    grams = [block.gram for block in blocks]
    total = np.sum(grams, axis=0)

    for has_own_sizes, equations in ((False, [total]), (True, grams)):
        own = {t: c for t, c in candidates.items() if t.is_of_each_power_on == has_own_sizes}
        explained = [_measure_powers(gram, own) for gram in equations]
        powers = {t: sum(power[t] for power in explained) for t in own}
        excess = {t: p - len(equations) * len(own[t]) for t, p in powers.items()}
        highest = max(excess.values(), default=0.0)
        if highest >= threshold:
            best = next(t for t in excess if excess[t] >= highest - POWER_TOLERANCE)
            sizes = [_fit_sizes(gram, own[best]) for gram in equations]
            return best, powers[best], sizes if has_own_sizes else sizes * len(grams)
    return None


def _compute_excess(block: Block) -> float:
    """Power of a residual beyond that of its noise."""
    return float(block.gram[-1, -1]) - block.rows


def _pursue(block: Block, columns: Columns) -> list[tuple[str, int | None, float]]:
    """Coordinate, harmonic and power of terms in one test."""
    excess = _compute_excess(block)
    if excess < MIN_EXCESS_SIGMA * np.sqrt(2 * block.rows):
        return []
    candidates = dict(columns)
    parts: list[tuple[str, int | None, float]] = []
    unplaced, gram = excess, block.gram.copy()
    while unplaced > max(MIN_POWER, UNPLACED_SHARE * excess) and candidates:
        powers = _measure_powers(gram, candidates)
        best = max(powers, key=lambda t: powers[t])
        if powers[best] < MIN_POWER:
            break
        power = min(powers[best], unplaced)
        parts.append((best.coordinate, best.harmonic, power))
        unplaced -= power
        gram = _project_out(gram, candidates.pop(best))
    if unplaced > MIN_POWER:
        parts.append(("noise", None, unplaced))
    return parts


def _measure_powers(gram: Array, candidates: Columns) -> dict[CandidateTerm, float]:
    """Decrease of the residual's power by a fit of each term alone."""
    powers = dict.fromkeys(candidates, 0.0)
    for size in {len(where) for where in candidates.values()}:
        terms = [term for term, where in candidates.items() if len(where) == size]
        rows = np.array([candidates[term] for term in terms])
        inverses = np.linalg.pinv(gram[rows[:, :, None], rows[:, None, :]], hermitian=True)
        products = gram[rows, -1]
        explained = np.einsum("ka,kab,kb->k", products, inverses, products)
        powers.update(zip(terms, explained.tolist(), strict=True))
    return powers


def _fit_sizes(gram: Array, where: NDArray[np.int64]) -> Array:
    """Least-squares sizes of these columns."""
    inverse = np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True)
    return np.asarray(inverse @ gram[where, -1])


def _project_out(gram: Array, where: NDArray[np.int64]) -> Array:
    """Products of the parts of all columns that are orthogonal to these."""
    inverse = np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True)
    return np.asarray(gram - gram[:, where] @ inverse @ gram[where, :])
