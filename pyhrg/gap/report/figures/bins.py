"""Mean residuals in bins of a coordinate, with the 95 % band of noise in each bin."""

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array

from pyhrg.common.arrays import Array
from pyhrg.gap.report.figures.views import FULL_TURN, Axis


@dataclass(frozen=True)
class Residual:
    """Residual of a channel in a test, in the unit of its view.

    before, after: (n,) of the nominal and of the identified gyro; NaN where record and simulation
        are not compared.
    noise: (n, d) simulated noise of the channel, d independent draws.
    """

    before: Array
    after: Array
    noise: Array


@dataclass(frozen=True)
class Bins:
    """Sums over the rows of each of b bins.

    edges: (b + 1,) of the bins, in the coordinate's unit.
    counts: (b,) rows.
    before, after: (b,) residual of the nominal and of the identified gyro.
    noise: (b, d) simulated noise.
    """

    edges: Array
    counts: Array
    before: Array
    after: Array
    noise: Array

    def __add__(self, other: "Bins") -> "Bins":
        """Sums over the rows of two tests, in the same bins."""
        names = ("counts", "before", "after", "noise")
        return Bins(self.edges, *(getattr(self, name) + getattr(other, name) for name in names))

    @property
    def means(self) -> "Means":
        """Mean residual of the bins that have rows."""
        kept = self.counts > 0
        n = self.counts[kept]
        centres = (self.edges[1:] + self.edges[:-1])[kept] / 2
        band = 1.96 * np.sqrt((self.noise[kept] ** 2).mean(axis=1)) / n
        width = float(self.edges[1] - self.edges[0])
        return Means(centres, width, self.before[kept] / n, self.after[kept] / n, band)


@dataclass(frozen=True)
class Means:
    """Mean residual in each bin that has rows, (b,) each.

    centres: of the bins, in the coordinate's unit.
    width: of a bin.
    before, after: mean residual of the nominal and of the identified gyro.
    band: half width of the interval around zero that holds the mean of noise with 95 % probability.
    """

    centres: Array
    width: float
    before: Array
    after: Array
    band: Array

    def count_outside(self, values: Array) -> int:
        """Number of bins whose value lies outside the band."""
        return int((np.abs(values) > self.band).sum())


def compute_edges(axis: Axis, low: float, high: float) -> Array:
    """(b + 1,) edges of bins over a range, whose ends are the centres of the first and of the last
    bin. The bins of an angle cover a full turn."""
    if axis.is_angle:
        return np.linspace(0.0, FULL_TURN, axis.bins + 1)
    half = (high - low) / (axis.bins - 1) / 2
    return np.linspace(low - half, high + half, axis.bins + 1)


def sum_in_bins(values: Array, edges: Array, axis: Axis, residual: Residual) -> Bins:
    """Sums over the rows of each bin, by the coordinate's value (n,) at each row. Rows outside all
    bins and rows that are not compared are left out."""
    place = np.mod(values, FULL_TURN) if axis.is_angle else values
    rows = np.isfinite(residual.before) & np.isfinite(residual.after) & np.isfinite(place)
    index = np.searchsorted(edges, place[rows], side="right") - 1
    index[place[rows] == edges[-1]] = len(edges) - 2
    b = len(edges) - 1
    # noise is drawn for all rows and summed over the rows that are compared
    sums = csr_array((np.ones(len(index)), (index, np.arange(len(index)))), shape=(b, len(index)))
    return Bins(
        edges,
        np.bincount(index, minlength=b).astype(float),
        sums @ residual.before[rows],
        sums @ residual.after[rows],
        sums @ residual.noise[rows],
    )


def find_extremes(values: Array, count: int) -> tuple[Array, Array, Array]:
    """Middle row, lowest and highest value of each stretch of rows that has values (n,); NaN is
    none. There are at most `count` stretches."""
    stretches = np.array_split(np.arange(len(values)), min(count, len(values)))
    kept = [s for s in (s[np.isfinite(values[s])] for s in stretches) if len(s)]
    return (
        np.array([s[len(s) // 2] for s in kept], dtype=float),
        np.array([values[s].min() for s in kept]),
        np.array([values[s].max() for s in kept]),
    )
