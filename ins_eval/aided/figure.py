"""Figure of the bias maps that a drive tells."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.aided.bias_map import BiasMap
from ins_eval.aided.hold_out import HoldOut
from ins_eval.error_model.error_budget import BODY
from pyhrg.common.arrays import Array
from pyhrg.common.units import DEG_PER_H, MINUTE

ANGLES = np.linspace(0.0, np.pi, 361)
COLOURS = dict(zip(BODY, ("tab:blue", "tab:orange", "tab:green"), strict=True))
BINS = 90
"""Parts of the half turn in which angles that were visited are marked."""


def plot_maps(
    estimate: BiasMap, prior: BiasMap, visited: Array | None, hold_out: HoldOut | None, name: str
) -> Figure:
    """Plot the map of each gyro with its one-sigma and the prior's, angles that the drive visited,
    and the error without fixes. visited: (m, 3) rad."""
    panels = len(COLOURS) + (hold_out is not None)
    figure = Figure(figsize=(8, 2.4 * panels), layout="constrained")
    rows = figure.subplots(panels, 1)
    bias, sigma = (x / DEG_PER_H for x in estimate.evaluate(ANGLES))
    known, spread = (x / DEG_PER_H for x in prior.evaluate(ANGLES))
    degrees = np.rad2deg(ANGLES)
    for axis, (title, colour) in enumerate(COLOURS.items()):
        axes: Axes = rows[axis]
        upper, lower = known[axis] + spread[axis], known[axis] - spread[axis]
        axes.plot(degrees, upper, "0.6", linestyle=":", label="one sigma before the drive")
        axes.plot(degrees, lower, "0.6", linestyle=":")
        low, high = bias[axis] - sigma[axis], bias[axis] + sigma[axis]
        axes.fill_between(degrees, low, high, color=colour, alpha=0.25, linewidth=0)
        axes.plot(degrees, bias[axis], color=colour, label="bias, with one sigma")
        if visited is not None:
            _mark_visited(axes, np.rad2deg(visited[:, axis]) % 180)
        axes.set_title(f"gyro {title}", loc="left", fontsize="medium")
        axes.set_ylabel("bias, deg/h")
        axes.set_xlim(0, 180)
        axes.grid(alpha=0.25)
    rows[0].legend(fontsize="small", loc="upper right")
    rows[len(COLOURS) - 1].set_xlabel("pattern angle, deg (bars: angles that the drive visited)")
    if hold_out is not None:
        _plot_hold_out(rows[-1], hold_out)
    figure.suptitle(name, parse_math=False)
    return figure


def _mark_visited(axes: Axes, degrees: Array) -> None:
    counts, edges = np.histogram(degrees, BINS, (0, 180))
    seen = counts > 0
    across = axes.get_xaxis_transform()
    axes.bar(
        edges[:-1][seen], 0.03, np.diff(edges)[seen], align="edge", color="k", transform=across
    )


def _plot_hold_out(axes: Axes, hold_out: HoldOut) -> None:
    minutes = hold_out.time / MINUTE
    axes.plot(minutes, hold_out.uncorrected, "0.5", label="errors left in")
    axes.plot(minutes, hold_out.corrected, "k", label="errors taken out")
    axes.set_title("free-inertial, judged by fixes held out", loc="left", fontsize="medium")
    axes.set_xlabel("time without fixes, min")
    axes.set_ylabel("distance, m")
    axes.legend(fontsize="small")
    axes.grid(alpha=0.25)
