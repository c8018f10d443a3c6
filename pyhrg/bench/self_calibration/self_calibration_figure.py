"""Figure of the self-calibration: the bias that a power-on shows, by where its pattern begins."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from pyhrg.bench.self_calibration.cycles import Cycle
from pyhrg.common.units import DEG, DEG_PER_H


def draw(figure: Figure, on: Sequence[Sequence[Cycle]], off: Sequence[Sequence[Cycle]]) -> None:
    """Means over a cycle, with virtual rotation and at rest."""
    axes = figure.add_subplot()
    for runs, mark, colour, label in (
        (off, "s", "#D55E00", "off: pattern left where it is"),
        (on, "o", "#0072B2", "on: one way and back"),
    ):
        points = [(c.pattern_angle, c.rate) for run in runs for c in run]
        angle, rate = np.array(points).T
        axes.plot(angle % np.pi / DEG, rate / DEG_PER_H, mark, color=colour, label=label)
    axes.set_xlabel("pattern angle at the beginning, deg")
    axes.set_ylabel("mean output at rest, deg/h")
    axes.set_title("Self-calibration by virtual rotation")
    axes.set_xlim(0, 180)
    axes.grid(alpha=0.3)
    axes.legend()
