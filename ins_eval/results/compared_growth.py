"""How the position error grows in cases that are compared: its figure and its table."""

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes

from ins_eval.common.metrics import median_interval
from pyhrg.common.arrays import Array
from pyhrg.common.units import NAUTICAL_MILE

TABLE = "position_error.csv"


def draw_growth(axes: Axes, time: Array, cases: Iterable[tuple[str, str | None, Array]]) -> None:
    """Draw the median radial error of each case with the band of its 95 % interval.

    time: (k,) s; cases: colour, label or None, and radial errors (n, k) of n triads, m.
    """
    hours = time / 3600
    for color, label, radial in cases:
        miles = radial / NAUTICAL_MILE
        axes.plot(hours, np.median(miles, axis=0), color=color, linewidth=2, label=label)
        band = np.array([median_interval(sample) for sample in miles.T])
        axes.fill_between(hours, band[:, 0], band[:, 1], color=color, alpha=0.12, linewidth=0)
    axes.set_yscale("log")
    axes.set_xlim(0, hours[-1])
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("median radial error (band: 95 %), log axis\nnmi (1 nmi = 1.852 km)")
    axes.grid(which="both", alpha=0.25)


def write_growth(folder: Path, time: Array, names: Sequence[str], radial: Array) -> None:
    """Write `TABLE`: a column for each triad in each case.

    time: (k,) s; names: of the cases; radial: (cases, n, k) errors, m.
    """
    numbers = range(1, radial.shape[1] + 1)
    header = ["time_s", *(f"{name}_triad_{n:03}_m" for name in names for n in numbers)]
    np.savetxt(
        folder / TABLE,
        np.column_stack([time, *radial.reshape(-1, len(time))]),
        fmt="%.6g",
        delimiter=",",
        newline="\r\n",
        header=",".join(header),
        comments="",
    )
