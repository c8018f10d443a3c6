"""Play: what follows a reading with backlash."""

import numpy as np

from pyhrg.common.arrays import Array
from pyhrg.common.caches.compiled import compile_loop


@compile_loop
def follow_with_play(series: Array, width: float) -> Array:
    """(n,) output of a play (backlash) operator of this width: hysteresis."""
    lagging = np.empty_like(series)
    last = series[0]
    for i, value in enumerate(series):
        last = min(max(last, value - width / 2), value + width / 2)
        lagging[i] = last
    return lagging
