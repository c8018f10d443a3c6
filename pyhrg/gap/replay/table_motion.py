"""How the turntable moved between the rows of a log."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy import sparse
from scipy.sparse import linalg

from pyhrg.bench.bench import between, middles

Array = NDArray[np.float64]

ENCODER = 1e-8
"""Turn of the table that is none, rad."""
ROUNDS = 40
"""Of fitting, at most."""
CLOSE = 0.1
"""Of a rate that is none: a round that moves rates by less is the last."""
ALTERNATING = 2.0
"""Of bends that are nothing special, over those of the motion that has few."""


@dataclass(frozen=True)
class TableMotion:
    """The table's rate: over each row linear, and a parabola that is zero at its ends.

    interval: of the rows, s.
    rates: (n + 1,) at the rows' bounds, rad/s; 0 at the start.
    swells: (n,) means of the parabolas, rad/s.
    """

    interval: float
    rates: Array
    swells: Array

    @property
    def means(self) -> Array:
        """(n,) over rows, rad/s."""
        return np.asarray((self.rates[1:] + self.rates[:-1]) / 2 + self.swells)

    def section(self, rows: slice) -> "TableMotion":
        """Of some rows alone."""
        return replace(self, rates=self.rates[rows.start : rows.stop + 1], swells=self.swells[rows])

    def rates_in(self, steps: int) -> Array:
        """(n, steps) means over equal steps of each row, rad/s."""
        bounds = np.arange(steps + 1) / steps
        swelling = np.diff(_swollen(bounds)) * steps
        return between(self.rates, middles(steps)) + self.swells[:, None] * swelling

    def turned_in(self, steps: int) -> Array:
        """(n, steps) turn from each row's begin to the middles of equal steps of it, rad."""
        share = middles(steps)
        linear = share * between(self.rates, share / 2)
        return self.interval * (linear + self.swells[:, None] * _swollen(share))


def _swollen(share: Array) -> Array:
    """Integral of the parabola of mean 1, from a row's begin."""
    return share**2 * (3 - 2 * share)


def table_motion(table_angle: Array, interval: float) -> TableMotion:
    """The motion that has an encoder's readings and is linear in every row; where that alternates,
    the one whose slope changes in as few rows as will do, and which is linear in as many.

    What an encoder rounds off, or a table does within a row, would go on alternating from bound to
    bound for ever.

    Args:
        table_angle: (n,) encoder at the rows' ends, rad; 0 at the start.
        interval: of the rows, s.
    """
    means = np.diff(table_angle, prepend=0.0) / interval
    linear = _motion(means, interval, _linear(means))
    if _bent(linear) <= ALTERNATING * ENCODER / interval:
        return linear
    few = _motion(means, interval, _sparse(means, interval))
    return few if ALTERNATING * _bent(few) < _bent(linear) else linear


def _motion(means: Array, interval: float, rates: Array) -> TableMotion:
    """With these means over rows, and (n,) rates at the rows' ends."""
    bounds = np.append(0.0, rates)
    return TableMotion(interval, bounds, means - (bounds[1:] + bounds[:-1]) / 2)


def _bent(motion: TableMotion) -> float:
    """A bend that is nothing special, and what is none, rad/s."""
    return ENCODER / motion.interval + float(np.median(np.abs(np.diff(motion.rates, 2))))


def _linear(means: Array) -> Array:
    """(n,) rates at the rows' ends of a motion that is linear in every row."""
    signs = (-1.0) ** np.arange(len(means))
    return np.asarray(2 * signs * np.cumsum(signs * means))


def _sparse(means: Array, interval: float) -> Array:
    """(n,) rates at the rows' ends where bends and swells cost the logarithm of their size:
    iteratively reweighted least squares (E. J. Candes, M. B. Wakin, S. P. Boyd, J. Fourier Anal.
    Appl. 14 (2008))."""
    n = len(means)
    rates = (means + np.append(means[1:], means[-1])) / 2
    rates[:-1][(means[1:] == 0) | (means[:-1] == 0)] = 0.0
    mean = sparse.diags_array([0.5, 0.5], offsets=[0, -1], shape=(n, n))
    bend = sparse.diags_array([1.0, -2.0, 1.0], offsets=[-1, 0, 1], shape=(n - 1, n))
    none = ENCODER / interval
    for _ in range(ROUNDS):
        swells, bends = means - mean @ rates, bend @ rates
        a, b = (1 / (np.abs(values) + none) ** 2 for values in (swells, bends))
        normal = mean.T @ sparse.diags_array(a) @ mean + bend.T @ sparse.diags_array(b) @ bend
        scale = 1 / np.sqrt(normal.diagonal())
        even = sparse.diags_array(scale)
        pull = mean.T @ (a * swells) - bend.T @ (b * bends)
        change = scale * linalg.spsolve(sparse.csc_array(even @ normal @ even), scale * pull)
        rates = rates + change
        if np.abs(change).max() < CLOSE * none:
            break
    return rates
