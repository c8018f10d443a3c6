"""Which groups would explain most of what a set leaves: the next ones that a search tries."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.arrays import Array
from pyhrg.gap.effects.design import Design
from pyhrg.gap.effects.linear_test import Group
from pyhrg.gap.evidence.evidence import get_min_free_variance


@dataclass(frozen=True)
class _GroupsOfSize:
    """The m groups that have d columns each.

    indices: (m,) of the groups.
    columns: (m, d) of the design.
    gram: (m, d, d) products of each group's own columns.
    min_variance: (m,) share of their power that a set must leave (`get_min_free_variance`).
    prior: (m,) log odds.
    """

    indices: NDArray[np.int64]
    columns: NDArray[np.int64]
    gram: Array
    min_variance: Array
    prior: Array

    def score(
        self, gram: Array, projection: Array, fitted: NDArray[np.int64], shares: Array
    ) -> Array:
        """(m,) log odds that each group would add to a set with k columns of the design, `fitted`:
        its prior, and half the decrease of chi-square. `shares`, (k, p): how much of each column of
        the set is in each column of the design. Directions in which the set leaves too little of a
        group's columns count nothing."""
        shared = np.moveaxis(gram[self.columns, fitted[:, None, None]], 0, 2)
        own_shares = shares[:, self.columns]
        own = self.gram - np.einsum("mak,kmb->mab", shared, own_shares)
        along = projection[self.columns] - np.einsum("kma,k->ma", own_shares, projection[fitted])
        values, vectors = np.linalg.eigh(own)
        powers = np.einsum("mai,ma->mi", vectors, along) ** 2
        is_free = values > self.min_variance[:, None]
        explained = np.divide(powers, values, out=np.zeros_like(powers), where=is_free)
        return np.asarray(explained.sum(axis=1) / 2 + self.prior)


class Extensions:
    """Groups of a design that may be added to a set, with prior log odds.

    groups, prior: of the whole design; `allowed`: indices of those that may be added.
    """

    def __init__(
        self,
        design: Design,
        groups: Sequence[Group],
        prior: Sequence[float],
        allowed: Collection[int],
    ) -> None:
        self._design = design
        self._columns = [design.columns[group] for group in groups]
        by_size: dict[int, list[int]] = {}
        for i in allowed:
            by_size.setdefault(len(self._columns[i]), []).append(i)
        self._by_size = []
        for own in by_size.values():
            columns = np.array([self._columns[i] for i in own])
            self._by_size.append(
                _GroupsOfSize(
                    np.array(own),
                    columns,
                    design.gram[columns[:, :, None], columns[:, None, :]],
                    np.array([get_min_free_variance(groups[i]) for i in own]),
                    np.array([prior[i] for i in own]),
                )
            )

    def list_best(self, key: Collection[int], count: int) -> list[int]:
        """Indices of those groups that a set lacks and that would explain most of what it leaves,
        the best first."""
        gram, projection = self._design.gram, self._design.projection
        fitted = np.concatenate([np.zeros(0, dtype=np.int64), *(self._columns[i] for i in key)])
        shares = np.linalg.solve(gram[np.ix_(fitted, fitted)], gram[fitted])
        scores = np.full(len(self._columns), -np.inf)
        for same in self._by_size:
            scores[same.indices] = same.score(gram, projection, fitted, shares)
        scores[list(key)] = -np.inf
        order = np.argsort(-scores, kind="stable")[:count]
        return [int(i) for i in order if scores[i] > -np.inf]
