"""Bias instability during an alignment: flicker noise that begins with the record.

Its value at the record's begin is part of the stated bias (docs/methods/alignment.md, Eqs. 8 and
9).
"""

import numpy as np

from pyhrg.common.arrays import Array

PROCESSES = 3
"""Number of Gauss-Markov processes that approximate flicker noise. Chosen: with them the Allan
deviation over 10 s to 100 s of a record of 300 s is right to 7 % (test_bias_instability.py)."""


def correlation_times(longest: float) -> Array:
    """Return the correlation times (3,), s, of the processes whose sum approximates flicker noise
    (`pyhrg.noise.coefficients.compute_process_variance`).

    They are the longest, a tenth and a hundredth of it. Faster variation is part of the sensors'
    white noise.
    """
    return np.asarray(longest / 10.0 ** np.arange(PROCESSES))


def mean_variance(coefficient: float) -> float:
    """Return the variance of the mean of flicker noise since its beginning: 2/pi B^2, at any
    time."""
    return 2 / np.pi * coefficient**2
