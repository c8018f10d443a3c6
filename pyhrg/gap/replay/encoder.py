"""White noise of the table encoder, which a replay would take for motion of the table."""

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
