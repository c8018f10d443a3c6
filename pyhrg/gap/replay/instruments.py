"""Errors of the bench's instruments that a replay would take for inputs: white noise of the table
encoder, and the quantization step of a temperature log where it exceeds the thermometer's noise."""

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.robust import estimate_robust_deviation
from pyhrg.common.units import ARCSEC

Array = NDArray[np.float64]

DIFFERENCE_ORDER = 4
"""Order of the differences: high enough that smooth motion and encoder errors that last for many
rows contribute almost nothing. Chosen."""
OUTLIER_SIGMA = 5.0
"""Differences above this many robust standard deviations are moves of the table. Chosen."""
MIN_DIFFERENCES = 30
"""Fewest differences from which the noise is estimated. Chosen."""
SIGNIFICANCE_SIGMA = 4.0
"""The noise counts as present above this many standard errors of its variance. Chosen."""
MIN_NOISE = 1e-8
"""Noise below this counts as none, rad. Chosen."""
NOTE = (
    "table_angle_deg: scatters by up to {:.2g} arcsec where the gyro does not, in {}: counts as "
    "noise of the encoder"
)

MIN_REPEATED_SHARE = 0.3
"""Share of readings that repeat the one before, above which noise is finer than the step.
Chosen."""
WHOLE_STEP_TOLERANCE = 0.25
"""Largest departure of a change from a whole number of steps, in steps: a printed step may be
rounded. Chosen."""
MIN_STEP, MAX_STEP = 1e-6, 2.0
"""Range of steps that are looked for, K: above the rounding of numbers, below changes of a set
point. Chosen."""
SINGLE_STEP_RATIO = 1.5
"""Changes up to this many times the smallest change are changes by one step. Chosen."""


def estimate_encoder_noise(table_angle: Array, gyro_angle: Array) -> float:
    """Standard deviation of the encoder's white noise, rad; 0 where it is not significant.

    Motion appears in encoder and gyro alike. The noise variance is therefore the covariance of the
    differences of (n,) encoder angles, rad, with those of encoder less gyro
    (docs/methods/replay.md, Eq. 4).
    """
    table, gyro = np.diff(table_angle, DIFFERENCE_ORDER), np.diff(gyro_angle, DIFFERENCE_ORDER)
    table, gyro = (series[np.isfinite(gyro)] for series in (table, gyro))
    kept = _is_inlier(table) & _is_inlier(table - gyro)
    products = (table * (table - gyro))[kept] / math.comb(2 * DIFFERENCE_ORDER, DIFFERENCE_ORDER)
    if len(products) < MIN_DIFFERENCES:
        return 0.0
    variance = float(np.mean(products))
    error = float(np.std(products)) / math.sqrt(len(products) / DIFFERENCE_ORDER)
    is_significant = variance > max(SIGNIFICANCE_SIGMA * error, MIN_NOISE**2)
    return math.sqrt(variance) if is_significant else 0.0


def _is_inlier(series: Array) -> NDArray[np.bool_]:
    return np.asarray(np.abs(series) <= OUTLIER_SIGMA * estimate_robust_deviation(series))


def describe_encoder_noise(noises: Mapping[str, float]) -> tuple[str, ...]:
    """One sentence for the report if any encoder is noisy, else none; noise by test, rad."""
    noisy = {name: noise for name, noise in noises.items() if noise}
    return (NOTE.format(max(noisy.values()) / ARCSEC, ", ".join(noisy)),) if noisy else ()


def estimate_reading_steps(logs: Mapping[str, Array]) -> dict[str, float]:
    """Quantization step of each (n,) temperature log, K; a log that never changes gets the finest
    step of the others. 0 means that the step is finer than the noise."""
    changes = {name: _compute_changes(log) for name, log in logs.items()}
    steps = {name: _estimate_step(own) for name, own in changes.items()}
    finest = min((step for step in steps.values() if step), default=0.0)
    return {name: steps[name] if own.any() else finest for name, own in changes.items()}


def estimate_toggling_step(log: Array) -> float:
    """Step between which a thermometer's readings, (n,) K, go to and fro, K; 0 where they don't."""
    changes = _compute_changes(log)
    goes_both_ways = changes.min(initial=0.0) < 0 < changes.max(initial=0.0)
    return _estimate_step(changes) if goes_both_ways else 0.0


def _compute_changes(log: Array) -> Array:
    """Changes from reading to reading, 0 where they are the rounding of numbers."""
    changes = np.diff(log[np.isfinite(log)])
    return np.asarray(np.where(np.abs(changes) > MIN_STEP, changes, 0.0))


def _estimate_step(changes: Array) -> float:
    """Step, K; 0 where it is finer than the noise, or readings never change."""
    sizes = np.abs(changes[changes != 0])
    if not len(sizes) or len(sizes) > (1 - MIN_REPEATED_SHARE) * len(changes):
        return 0.0
    step = float(np.median(sizes[sizes < SINGLE_STEP_RATIO * sizes.min()]))
    counts = sizes / step
    is_whole = np.all(np.abs(counts - np.round(counts)) < WHOLE_STEP_TOLERANCE)
    return step if step < MAX_STEP and is_whole else 0.0
