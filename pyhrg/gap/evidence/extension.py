"""Which groups would explain most of what a set leaves: the next ones that a search tries."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.design import Design, Group
from pyhrg.gap.evidence.evidence import min_free_variance


@dataclass(frozen=True)
class _Alike:
    """The m groups that have d columns each.

    indices: (m,) of the groups.
    columns: (m, d) of the design.
    min_variance: (m,) share of their power that a set must leave (`min_free_variance`).
    prior: (m,) log odds.
    """

    indices: NDArray[np.int64]
    columns: NDArray[np.int64]
    min_variance: Array
    prior: Array

    def score(self, gram: Array, projection: Array, fitted: NDArray[np.int64]) -> Array:
        """(m,) log odds that each group would add to a set with these columns of the design: its
        prior, and half the decrease of chi-square. Directions in which the set leaves too little of
        its columns count nothing."""
        own = gram[self.columns[:, :, None], self.columns[:, None, :]]
        along = projection[self.columns]
        if len(fitted):
            shared = gram[self.columns][:, :, fitted]
            shares = np.linalg.solve(gram[np.ix_(fitted, fitted)], gram[fitted])[:, self.columns]
            own = own - np.einsum("mak,kmb->mab", shared, shares)
            along = along - np.einsum("kma,k->ma", shares, projection[fitted])
        values, vectors = np.linalg.eigh(own)
        powers = np.einsum("mai,ma->mi", vectors, along) ** 2
        is_free = values > self.min_variance[:, None]
        explained = np.divide(powers, values, out=np.zeros_like(powers), where=is_free)
        return np.asarray(explained.sum(axis=1) / 2 + self.prior)


class Extensions:
    """Groups of a design, by their number of columns, with prior log odds."""

    def __init__(self, design: Design, groups: Sequence[Group], prior: Sequence[float]) -> None:
        self._design = design
        self._columns = [design.columns[group] for group in groups]
        self._prior = np.array(prior)
        sizes = np.array([len(own) for own in self._columns])
        free = np.array([min_free_variance(group) for group in groups])
        self._alike = [
            _Alike(
                np.flatnonzero(sizes == size),
                np.array([own for own in self._columns if len(own) == size]),
                free[sizes == size],
                self._prior[sizes == size],
            )
            for size in np.unique(sizes)
        ]

    def list_best(self, key: Collection[int], allowed: Collection[int], count: int) -> list[int]:
        """Indices of those allowed groups that a set lacks and that would explain most of what it
        leaves, the best first."""
        gram, projection = self._design.gram, self._design.projection
        fitted = np.concatenate([np.zeros(0, dtype=np.int64), *(self._columns[i] for i in key)])
        scores = np.full(len(self._columns), -np.inf)
        for alike in self._alike:
            scores[alike.indices] = alike.score(gram, projection, fitted)
        others = np.array([i for i in allowed if i not in key], dtype=np.int64)
        order = np.argsort(-scores[others], kind="stable")[:count]
        return [int(i) for i in others[order]]
