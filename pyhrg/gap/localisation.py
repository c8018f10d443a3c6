"""Where a gap lives: test, channel and coordinate, with shares of its power that add up."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.gap.design import Block, Design
from pyhrg.gap.unknown import Element

Array = NDArray[np.float64]

PLAIN = 25.0
"""Power, in deviations of the noise squared, below which no coordinate is seen."""
REST = 0.01
"""Share of a block's excess that need not be placed."""


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

    Within a channel of a test, elements are taken out one by one, each with all that only it
    explains; what no element explains is `noise`.

    Args:
        design: whitened by the believed noise.
    """
    elements = [g for g in design.places if isinstance(g, Element)]
    found: dict[tuple[str, str, str, int | None], float] = {}
    for block in design.blocks:
        for coordinate, harmonic, power in _parts(block, elements, design):
            key = (block.test, block.channel, coordinate, harmonic)
            found[key] = found.get(key, 0.0) + power
    whole = sum(found.values())
    places = [Place(*key, float(np.sqrt(p)), p / whole) for key, p in found.items()]
    return tuple(sorted(places, key=lambda place: -place.share))


def _parts(
    block: Block, elements: Sequence[Element], design: Design
) -> list[tuple[str, int | None, float]]:
    excess = float(block.gram[-1, -1]) - block.rows
    if excess < 5 * np.sqrt(2 * block.rows):
        return []
    own = [e for e in elements if e.channel == block.channel]
    first = len(block.gram) - 1 - sum(len(design.places[e]) for e in own)
    columns, begin = {}, first
    for element in own:
        columns[element] = np.arange(begin, begin + len(design.places[element]))
        begin += len(design.places[element])
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
    pull = gram[where, -1]
    return float(pull @ np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True) @ pull)


def _without(gram: Array, where: NDArray[np.int64]) -> Array:
    """Products of what is left of all columns beside these."""
    inverse = np.linalg.pinv(gram[np.ix_(where, where)], hermitian=True)
    return np.asarray(gram - gram[:, where] @ inverse @ gram[where, :])
