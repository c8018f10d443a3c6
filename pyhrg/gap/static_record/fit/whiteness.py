"""How white a record is once the noise model is divided out."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.special import polygamma
from scipy.stats import chi2

from pyhrg.gap.static_record.fit.unknowns import octaves

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Whiteness:
    """rms: 1 where the model is right;
    octaves: (k,) mean squares, the fastest first;
    log_rms: of their logarithms; log_floor: what chance leaves of it;
    p_value: that a white record's most conspicuous octave is as conspicuous (two-sided chi-square,
    Bonferroni).
    """

    rms: float
    octaves: Array
    log_rms: float
    log_floor: float
    p_value: float


def whiteness(white: Array) -> Whiteness:
    """Of (m,) whitened coefficients."""
    bands = octaves(len(white))
    count = np.array([band.stop - band.start for band in bands])
    power = np.array([np.sum(white[band] ** 2) for band in bands])
    tail = 2 * np.minimum(chi2.cdf(power, count), chi2.sf(power, count))
    p_value = min(1.0, float(len(bands) * np.min(tail)))
    mean = power / count
    return Whiteness(
        rms=float(np.sqrt(np.mean(white**2))),
        octaves=mean,
        log_rms=float(np.sqrt(np.mean(np.log(mean) ** 2))),
        log_floor=float(np.sqrt(np.mean(polygamma(1, count / 2)))),
        p_value=p_value,
    )
