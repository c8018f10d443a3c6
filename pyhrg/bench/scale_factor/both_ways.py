"""Drawing of turns in both directions against the pattern angle."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from pyhrg.bench.readings.turns import Turn
from pyhrg.common.units import DEG

Array = NDArray[np.float64]


def draw_both_ways(
    axes: Axes, turns: Sequence[Turn], points: Sequence[tuple[Array, Array]]
) -> None:
    """Draw the points of turns on axes, with one label for each direction.

    `points` has pattern angles (m,), rad, and values (m,) of each turn.
    """
    for positive, mark, colour in ((True, ".", "C0"), (False, "x", "C1")):
        chosen = [i for i, turn in enumerate(turns) if (turn.table_rate > 0) == positive]
        angle = np.concatenate([points[i][0] for i in chosen]) % np.pi / DEG
        values = np.concatenate([points[i][1] for i in chosen])
        rate = np.mean([turns[i].table_rate for i in chosen]) / DEG
        label = f"{rate:+.3g} deg/s"
        axes.plot(angle, values, mark, color=colour, ms=2.5, label=label, alpha=0.5)
    axes.set_xlabel("pattern angle, deg")
    axes.set_xlim(0, 180)
    axes.grid(alpha=0.3)
