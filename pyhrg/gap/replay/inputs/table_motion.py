"""Motion of the turntable between the rows of a log."""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from scipy.linalg import solve_banded

from pyhrg.bench.programme import compute_step_middles, interpolate_rows
from pyhrg.common.arrays import Array

NEGLIGIBLE_TURN = 1e-8
"""Turn of the table in a row that counts as zero, rad. Chosen: about three times the largest second
difference, 3.5e-9, that rounding to the format's seven decimals of a degree makes."""
NOISE_TURN = 4.0
"""Turn of the table in a row that counts as zero, in standard deviations of the encoder's noise.
Chosen: the difference of two readings exceeds it once in 200."""
MAX_ITERATIONS = 40
"""Most iterations of the reweighted fit. Chosen."""
CONVERGENCE_SHARE = 0.1
"""The fit has converged when no rate changes by more than this share of `NEGLIGIBLE_TURN` a
row. Chosen."""
ALTERNATION_RATIO = 2.0
"""Bends of the piecewise linear motion, over those of the sparse one, above which the sparse motion
is taken. Chosen."""


@dataclass(frozen=True)
class TableMotion:
    """The table's rate: within each row a straight line plus a parabola that is zero at both ends.

    interval: of the rows, s.
    rates: (n + 1,) at the rows' bounds, rad/s; 0 at the start.
    parabola_means: (n,) mean of the parabola over each row, rad/s.
    """

    interval: float
    rates: Array
    parabola_means: Array

    @property
    def means(self) -> Array:
        """(n,) mean rate over each row, rad/s: the encoder's increment over the interval."""
        return np.asarray((self.rates[1:] + self.rates[:-1]) / 2 + self.parabola_means)

    def section(self, rows: slice) -> "TableMotion":
        """The motion in some rows."""
        rates = self.rates[rows.start : rows.stop + 1]
        return replace(self, rates=rates, parabola_means=self.parabola_means[rows])

    def compute_rates(self, steps: int) -> Array:
        """(n, steps) mean rates over equal steps of each row, rad/s."""
        bounds = np.arange(steps + 1) / steps
        parabola = np.diff(_integrate_parabola(bounds)) * steps
        linear = interpolate_rows(self.rates, compute_step_middles(steps))
        return linear + self.parabola_means[:, None] * parabola

    def compute_turns(self, steps: int) -> Array:
        """(n, steps) turn from each row's begin to the middles of equal steps of it, rad."""
        share = compute_step_middles(steps)
        linear = share * interpolate_rows(self.rates, share / 2)
        parabola = self.parabola_means[:, None] * _integrate_parabola(share)
        return self.interval * (linear + parabola)


def _integrate_parabola(share: Array) -> Array:
    """Integral of the parabola of mean 1 from a row's begin to a share of the row."""
    return share**2 * (3 - 2 * share)


def estimate_table_motion(table_angle: Array, interval: float, noise: float = 0.0) -> TableMotion:
    """The motion that reproduces exactly the encoder's readings at the rows' ends, (n,) rad, from 0
    at the start; `noise` is the standard deviation of theirs.

    The piecewise linear rate is taken unless it alternates from bound to bound. It does after
    rounding of the encoder, and after a move that ends within a row. Then the motion with the
    fewest rows with a bend or a parabola is taken (docs/methods/replay.md, Eqs. 2 and 3).
    """
    return _estimate_once(table_angle.tobytes(), interval, noise)


@lru_cache(maxsize=64)
def _estimate_once(encoder: bytes, interval: float, noise: float) -> TableMotion:
    """Motion of readings as bytes; kept, because a test is prepared several times."""
    readings = np.frombuffer(encoder)
    means = np.diff(readings, prepend=0.0) / interval
    negligible = max(NEGLIGIBLE_TURN, NOISE_TURN * noise) / interval
    signs = (-1.0) ** np.arange(len(means))
    linear = _build_motion(means, interval, np.asarray(2 * signs * np.cumsum(signs * means)))
    if _median_bend(linear) <= ALTERNATION_RATIO * NEGLIGIBLE_TURN / interval:
        return linear
    few = _build_motion(means, interval, _fit_sparse(means, negligible))
    return few if ALTERNATION_RATIO * _median_bend(few) < _median_bend(linear) else linear


def _build_motion(means: Array, interval: float, rates: Array) -> TableMotion:
    """Motion with these means over rows, and (n,) rates at the rows' ends."""
    bounds = np.append(0.0, rates)
    return TableMotion(interval, bounds, means - (bounds[1:] + bounds[:-1]) / 2)


def _median_bend(motion: TableMotion) -> float:
    """Median second difference of the rates, plus a negligible turn a row, rad/s."""
    bends = np.abs(np.diff(motion.rates, 2))
    return NEGLIGIBLE_TURN / motion.interval + float(np.median(bends))


def _fit_sparse(means: Array, negligible: float) -> Array:
    """(n,) rates at the rows' ends with the smallest sum of logarithms of bends and parabolas, each
    plus a negligible rate.

    Iteratively reweighted least squares (E. J. Candes, M. B. Wakin, S. P. Boyd, J. Fourier Anal.
    Appl. 14 (2008)); docs/methods/replay.md, Eq. 3.
    """
    rates = (means + np.append(means[1:], means[-1])) / 2
    is_at_rest = np.abs(means) <= negligible
    rates[:-1][is_at_rest[1:] | is_at_rest[:-1]] = 0.0
    for _ in range(MAX_ITERATIONS):
        bounds = np.append(0.0, rates)
        parabolas, bends = means - (bounds[1:] + bounds[:-1]) / 2, np.diff(bounds, 2)
        change = _solve_step(parabolas, bends, negligible)
        rates = rates + change
        if np.abs(change).max() < CONVERGENCE_SHARE * negligible:
            break
    return rates


def _solve_step(parabolas: Array, bends: Array, negligible: float) -> Array:
    """(n,) change of the rates that minimises the sum of squares of (n,) parabolas and (n - 1,)
    bends, each over itself and a negligible one: its normal equations have five diagonals."""
    a, b = (1 / (np.abs(values) + negligible) ** 2 for values in (parabolas, bends))
    bands = np.zeros((5, len(a)))
    bands[2] = a / 4
    bands[2, :-1] += a[1:] / 4 + 4 * b
    bands[2, :-2] += b[1:]
    bands[2, 1:] += b
    bands[1, 1:] = a[1:] / 4 - 2 * b
    bands[1, 1:-1] -= 2 * b[1:]
    bands[0, 2:] = b[1:]
    gradient, pulls = a * parabolas / 2, b * bends
    gradient[:-1] += gradient[1:] + 2 * pulls
    gradient[:-2] -= pulls[1:]
    gradient[1:] -= pulls
    scale = 1 / np.sqrt(bands[2])
    bands[2] = 1.0
    bands[1, 1:] *= scale[1:] * scale[:-1]
    bands[0, 2:] *= scale[2:] * scale[:-2]
    bands[3, :-1], bands[4, :-2] = bands[1, 1:], bands[0, 2:]
    return np.asarray(scale * solve_banded((2, 2), bands, scale * gradient))
