"""A first-order lag behind a sampled series."""

import math

import numpy as np
from scipy.signal import lfilter

from pyhrg.common.arrays import Array


def follow_with_lag(
    series: Array, interval: float, lag: float, start: float | None = None
) -> Array:
    """(n,) values that follow a series with a first-order lag, s. The series is linear between its
    rows, an interval in s apart. The first value is that of the series unless another is given."""
    kept = math.exp(-interval / lag)
    slopes = np.diff(series, prepend=series[0]) / interval
    apart = 0.0 if start is None else series[0] - start
    behind, _ = lfilter([lag * (1 - kept)], [1.0, -kept], slopes, zi=[apart])
    return np.asarray(series - behind)
