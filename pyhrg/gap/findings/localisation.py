"""Where a gap lives: test, channel and coordinate, with shares of its power that add up."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.effects.candidate_terms import Element
from pyhrg.gap.effects.design import Block, Design

Array = NDArray[np.float64]
Columns = Mapping[Element, NDArray[np.int64]]

PLAIN = 25.0
"""Power, in deviations of the noise squared, below which no coordinate is seen."""
EVIDENT = 5.0
"""Deviations of a block's power from which its excess is placed."""
REST = 0.01
"""Share of a block's excess that need not be placed."""


ALIKE = 4.0
"""Difference in power by which one element explains no better than another."""


@dataclass(frozen=True)
class Place:
    """A share of the gap.

    sigmas: root of its power, in deviations of the noise.
    share: of the power of the whole gap.
    """

    test: str
    channel: str
    coordinate: str
    harmonic: int | None
    sigmas: float
    share: float


def located(design: Design) -> tuple[Place, ...]:
    """Where the residual has more power than its noise, the largest share first.

    Within a channel, elements are taken out one by one: first of all tests together, with the same
    sizes, then of tests that have more. What no element explains is `noise`.

    Args:
        design: whitened by the believed noise.
    """
    elements = [g for g in design.places if isinstance(g, Element)]
    found: dict[tuple[str, str, str, int | None], float] = {}
    for channel in dict.fromkeys(block.channel for block in design.blocks):
        blocks = [block for block in design.blocks if block.channel == channel]
        seen = [element for element in elements if element.channel == channel]
        columns = {e: np.flatnonzero(np.isin(blocks[0].columns, design.places[e])) for e in seen}
        shared, blocks = _shared(blocks, columns)
        own = [(block.test, *part) for block in blocks for part in _parts(block, columns)]
        for test, coordinate, harmonic, power in (*shared, *own):
            key = (test, channel, coordinate, harmonic)
            found[key] = found.get(key, 0.0) + power
    whole = sum(found.values())
    places = [Place(*key, float(np.sqrt(p)), p / whole) for key, p in found.items()]
    return tuple(sorted(places, key=lambda place: -place.share))


def _shared(
    blocks: Sequence[Block], columns: Columns
) -> tuple[list[tuple[str, str, int | None, float]], list[Block]]:
    """Test, coordinate, harmonic, and power of what elements explain of all; what they leave."""
    parts = []
    least = max(PLAIN, REST * sum(_excess(block) for block in blocks))
    candidates = dict(columns)
    while (found := _first(blocks, candidates, least)) is not None:
        best, power, sizes = found
        where = candidates.pop(best)
        after = [
            replace(block, gram=_less(block.gram, where, own))
            for block, own in zip(blocks, sizes, strict=True)
        ]
        gained = [max(_excess(b) - _excess(a), 0.0) for b, a in zip(blocks, after, strict=True)]
        for block, own in zip(blocks, gained, strict=True):
            if own > 0:
                share = own / sum(gained)
                parts.append((block.test, best.coordinate, best.harmonic, share * power))
        blocks = after
    return parts, list(blocks)


def _first(
    blocks: Sequence[Block], candidates: Columns, least: float
) -> tuple[Element, float, list[Array]] | None:
    """Element to be taken out first, what it explains of all tests, and its sizes in each: the
    first of those that explain as much as any; what has a size for each test only when nothing else
    is left.
    """
    grams = [block.gram for block in blocks]
    total = np.sum(grams, axis=0)

    def seen_in(element: Element) -> list[Array]:
        """Equations that it has sizes of its own for."""
        return grams if element.is_of_each_power_on else [total]

    def explained(element: Element) -> float:
        return sum(_power(gram, candidates[element]) for gram in seen_in(element))

    for foretells in (True, False):
        powers = {e: explained(e) for e in candidates if e.foretells == foretells}
        beyond = {e: p - len(seen_in(e)) * len(candidates[e]) for e, p in powers.items()}
        most = max(beyond.values(), default=0.0)
        if most >= least:
            best = next(e for e in beyond if beyond[e] >= most - ALIKE)
            sizes = [_sizes(gram, candidates[best]) for gram in seen_in(best)]
            return best, powers[best], sizes if len(sizes) == len(grams) else sizes * len(grams)
    return None


def _excess(block: Block) -> float:
    """Power of a residual beyond that of its noise."""
    return float(block.gram[-1, -1]) - block.rows


def _parts(block: Block, columns: Columns) -> list[tuple[str, int | None, float]]:
    excess = _excess(block)
    if excess < EVIDENT * np.sqrt(2 * block.rows):
        return []
    columns = dict(columns)
    parts: list[tuple[str, int | None, float]] = []
    left, gram = excess, block.gram.copy()
    while left > max(PLAIN, REST * excess) and columns:
        powers = {e: _power(gram, where) for e, where in columns.items()}
        best = max(powers, key=lambda e: powers[e])
        if powers[best] < PLAIN:
            break
        taken = min(powers[best], left)
        parts.append((best.coordinate, best.harmonic, taken))
        left -= taken
        gram = _without(gram, columns.pop(best))
    if left > PLAIN:
        parts.append(("noise", None, left))
    return parts


def _power(gram: Array, where: NDArray[np.int64]) -> float:
    """Of the residual that these columns explain."""
    return float(gram[where, -1] @ _sizes(gram, where))


def _sizes(gram: Array, where: NDArray[np.int64]) -> Array:
    """Of these columns, so that they explain most."""
    inverse = np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True)
    return np.asarray(inverse @ gram[where, -1])


def _less(gram: Array, where: NDArray[np.int64], sizes: Array) -> Array:
    """Products where columns of these sizes are taken out of the residual."""
    change = np.eye(len(gram))
    change[where, -1] = -sizes
    return np.asarray(change.T @ gram @ change)


def _without(gram: Array, where: NDArray[np.int64]) -> Array:
    """Products of what is left of all columns beside these."""
    inverse = np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True)
    return np.asarray(gram - gram[:, where] @ inverse @ gram[where, :])
