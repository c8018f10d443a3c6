"""Residuals gathered in bins of a coordinate, with what noise alone leaves in each."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from pyhrg.gap.report.figures.views import TURN, Axis

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Residual:
    """A channel of a test, in the unit of its view.

    before, after: (n,) NaN where they are not compared.
    noise: (n, d) draws of noise alone.
    """

    before: Array
    after: Array
    noise: Array


@dataclass(frozen=True)
class Bins:
    """Sums over the rows of each bin.

    edges: (b + 1,) of the coordinate.
    counts: (b,).
    before, after: (b,).
    noise: (b, d).
    """

    edges: Array
    counts: Array
    before: Array
    after: Array
    noise: Array

    def __add__(self, other: "Bins") -> "Bins":
        """Both, in the same bins."""
        return Bins(
            self.edges,
            self.counts + other.counts,
            self.before + other.before,
            self.after + other.after,
            self.noise + other.noise,
        )

    @property
    def means(self) -> "Means":
        """Of the bins that have rows."""
        there = self.counts > 0
        n = self.counts[there]
        centres = (self.edges[1:] + self.edges[:-1])[there] / 2
        band = 1.96 * np.sqrt((self.noise[there] ** 2).mean(axis=1)) / n
        width = float(self.edges[1] - self.edges[0])
        return Means(centres, width, self.before[there] / n, self.after[there] / n, band)


@dataclass(frozen=True)
class Means:
    """Mean residual in each bin that has rows, (b,) each.

    at: middles of the bins.
    width: of a bin.
    band: that noise alone stays within in 95 % of cases, either way.
    """

    at: Array
    width: float
    before: Array
    after: Array
    band: Array

    def outside(self, values: Array) -> int:
        """Bins in which noise alone would rarely be."""
        return int((np.abs(values) > self.band).sum())


def edges(axis: Axis, low: float, high: float) -> Array:
    """Of bins over a range, whose ends are in the middle of the first and the last; an angle's go
    round."""
    if axis.turns:
        return np.linspace(0.0, TURN, axis.bins + 1)
    half = (high - low) / (axis.bins - 1) / 2
    return np.linspace(low - half, high + half, axis.bins + 1)


def gathered(values: Array, bounds: Array, axis: Axis, residual: Residual) -> Bins:
    """Rows by bin; those outside and those that are not compared are left out.

    Args:
        values: (n,) of the coordinate.
        bounds: (b + 1,) of the bins.
        axis: the coordinate's.
        residual: of the rows.
    """
    place = np.mod(values, TURN) if axis.turns else values
    rows = np.isfinite(residual.before) & np.isfinite(residual.after) & np.isfinite(place)
    index = np.searchsorted(bounds, place[rows], side="right") - 1
    index[place[rows] == bounds[-1]] = len(bounds) - 2
    b = len(bounds) - 1
    # sums of draws that miss no row: noise of rows that are not compared is left out alike
    sums = csr_array((np.ones(len(index)), (index, np.arange(len(index)))), shape=(b, len(index)))
    return Bins(
        bounds,
        np.bincount(index, minlength=b).astype(float),
        sums @ residual.before[rows],
        sums @ residual.after[rows],
        sums @ residual.noise[rows],
    )


def extremes(values: Array, bins: int) -> tuple[Array, Array, Array]:
    """Row, lowest and highest value of stretches of rows, those without a value left out.

    Args:
        values: (n,) NaN where there is none.
        bins: stretches at most.
    """
    stretches = np.array_split(np.arange(len(values)), min(bins, len(values)))
    kept = [s[np.isfinite(values[s])] for s in stretches]
    kept = [s for s in kept if len(s)]
    return (
        np.array([s[len(s) // 2] for s in kept], dtype=float),
        np.array([values[s].min() for s in kept]),
        np.array([values[s].max() for s in kept]),
    )
