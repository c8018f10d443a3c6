"""Whiteness of a record after division by the noise model."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import polygamma
from scipy.stats import chi2

from pyhrg.gap.static_record.fit.unknowns import sum_octaves

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Whiteness:
    """Statistics of whitened coefficients.

    rms: root mean square; 1 where the model is right.
    octaves: (k,) mean square in each octave, from the highest frequencies down.
    log_rms: root mean square of the octaves' logarithms.
    log_floor: expectation of `log_rms` for white noise.
    p_value: probability that white noise deviates as far in its most deviating octave (two-sided
        chi-square test with the Bonferroni correction).
    """

    rms: float
    octaves: Array
    log_rms: float
    log_floor: float
    p_value: float


def measure_whiteness(white: Array) -> Whiteness:
    """Statistics of (m,) whitened coefficients."""
    power, count = sum_octaves(white)
    tail = 2 * np.minimum(chi2.cdf(power, count), chi2.sf(power, count))
    mean = power / count
    return Whiteness(
        rms=float(np.sqrt(np.mean(white**2))),
        octaves=mean,
        log_rms=float(np.sqrt(np.mean(np.log(mean) ** 2))),
        log_floor=float(np.sqrt(np.mean(polygamma(1, count / 2)))),
        p_value=min(1.0, float(len(power) * np.min(tail))),
    )
