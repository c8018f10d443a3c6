"""Bias instability during an alignment: flicker noise that begins with the record.

Its variation before the record counts as the stated bias (docs/methods/alignment.md, Eqs. 8, 9).
"""

import numpy as np

from ins_eval.common.arrays import Array

PROCESSES = 3
"""Number of Gauss-Markov processes that approximate flicker noise. Chosen."""
RATIO = 10.0
"""Ratio of one correlation time to the next. Chosen."""


def correlation_times(longest: float) -> Array:
    """Return the correlation times (3,), s, of the processes whose sum approximates flicker noise.

    They are the longest, a tenth and a hundredth of it. Faster variation is part of the sensors'
    white noise.
    """
    return np.asarray(longest / RATIO ** np.arange(PROCESSES))


def process_variance(coefficient: float) -> float:
    """Return the variance of each process, B^2 ln r / pi.

    Processes of equal variance v whose correlation times T have the ratio r have the total density
    sum of 2 v T/(1 + (w T)^2). As an integral over the logarithm of T it is pi v/(w ln r), and that
    of flicker noise is B^2/w.

    coefficient: B of IEEE Std 952, in the unit of the noise.
    """
    return coefficient**2 * np.log(RATIO) / np.pi


def mean_variance(coefficient: float) -> float:
    """Return the variance of the mean of flicker noise since its beginning: 2/pi B^2, at any
    time."""
    return 2 / np.pi * coefficient**2
