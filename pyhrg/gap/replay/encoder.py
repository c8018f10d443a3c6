"""Noise of the turntable's encoder, which a replay takes for motion."""

import math
from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pyhrg.common.robust import robust_deviation
from pyhrg.common.units import ARCSEC

Array = NDArray[np.float64]

ORDER = 4
"""Of the differences, that no motion or error of the encoder that lasts for rows is seen in."""
CLIP = 5.0
"""Differences further out than this many deviations are moves of the table."""
FEW = 30
"""Differences below which nothing is told."""
SURE = 4.0
"""Standard errors from which it is noise."""
LEAST = 1e-8
"""Noise that is none, rad."""
NOTE = (
    "table_angle_deg: scatters by up to {:.2g} arcsec where the gyro does not, in {}: counts as "
    "noise of the encoder"
)


def encoder_noise(table_angle: Array, gyro_angle: Array) -> float:
    """White noise of an encoder's readings, rad; 0 where it can't be told from none.

    What encoder and gyro show alike is motion: the variance is the covariance of the encoder's
    differences and what they have that the gyro's have not.

    Args:
        table_angle: (n,) rad.
        gyro_angle: (n,) rad; NaN where there is none.
    """
    table, gyro = np.diff(table_angle, ORDER), np.diff(gyro_angle, ORDER)
    table, gyro = (series[np.isfinite(gyro)] for series in (table, gyro))
    kept = _is_usual(table) & _is_usual(table - gyro)
    products = (table * (table - gyro))[kept] / math.comb(2 * ORDER, ORDER)
    if len(products) < FEW:
        return 0.0
    variance = float(np.mean(products))
    error = float(np.std(products)) / math.sqrt(len(products) / ORDER)
    return math.sqrt(variance) if variance > max(SURE * error, LEAST**2) else 0.0


def _is_usual(series: Array) -> NDArray[np.bool_]:
    return np.asarray(np.abs(series) <= CLIP * robust_deviation(series))


def encoder_notes(noises: Mapping[str, float]) -> tuple[str, ...]:
    """A sentence where there is any.

    Args:
        noises: by test, rad.
    """
    noisy = {name: noise for name, noise in noises.items() if noise}
    return (NOTE.format(max(noisy.values()) / ARCSEC, ", ".join(noisy)),) if noisy else ()
