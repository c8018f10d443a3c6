"""The figure of a comparison: position-error growth by case, and ratios at the end."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from ins_eval.common.metrics import median_interval
from ins_eval.parking.case import CASES
from ins_eval.parking.study import Comparison, compare_with_first_case
from pyhrg.common.units import NAUTICAL_MILE

COLORS = ("black", "tab:blue", "tab:orange", "tab:red", "tab:green")


def plot_comparison(result: Comparison) -> Figure:
    """Growth of the position error by case, and ratios to the first case."""
    figure = Figure(figsize=(11, 5), layout="constrained")
    growth, ratios = figure.subplots(1, 2, width_ratios=(1.5, 1))
    _draw_growth(growth, result)
    _draw_ratios(ratios, result)
    n = result.radial.shape[1]
    title = f"Patterns of level gyros parked at power-on: {n} triads on {result.mission}"
    figure.suptitle(title, parse_math=False)  # a mission's name is no formula
    return figure


def _draw_growth(axes: Axes, result: Comparison) -> None:
    hours = result.time / 3600
    for color, radial in zip(COLORS, result.radial / NAUTICAL_MILE, strict=True):
        axes.plot(hours, np.median(radial, axis=0), color=color, linewidth=2)
        band = np.array([median_interval(sample) for sample in radial.T])
        axes.fill_between(hours, band[:, 0], band[:, 1], color=color, alpha=0.12, linewidth=0)
    axes.set_yscale("log")
    axes.set_ylim(bottom=np.median(result.radial[:, :, -1], axis=1).min() / NAUTICAL_MILE / 30)
    axes.set_xlim(0, hours[-1])
    axes.set_xlabel("time since alignment, h")
    axes.set_ylabel("median radial error (band: 95 %), log axis\nnmi (1 nmi = 1.852 km)")
    axes.grid(which="both", alpha=0.25)


def _draw_ratios(axes: Axes, result: Comparison) -> None:
    rows = np.arange(len(CASES))
    kinds = (
        (result.final, -0.15, "o", f"at {result.hours:g} h"),
        (result.greatest, 0.15, "s", f"greatest within {result.hours:g} h"),
    )
    for radial, beside, marker, name in kinds:
        for row, color, ratio in zip(
            rows + beside, COLORS, compare_with_first_case(radial), strict=True
        ):
            axes.plot([ratio.low, ratio.high], [row, row], color=color, linewidth=2)
            axes.plot(ratio.value, row, marker, color=color)
            text, above = f"{ratio.value:.2g}", 5 if beside < 0 else -14
            at = (ratio.value, row)
            axes.annotate(text, at, (0, above), textcoords="offset points", ha="center")
        axes.plot([], [], marker, color="0.4", label=name)
    axes.legend(loc="upper left", framealpha=0.95)
    axes.axvline(1.0, color="0.6", linewidth=1)
    axes.set_xscale("log")
    axes.set_yticks(rows, [case.label.replace(", ", ",\n") for case in CASES])
    for tick, color in zip(axes.get_yticklabels(), COLORS, strict=True):
        tick.set_color(color)
    axes.invert_yaxis()
    axes.margins(y=0.15)
    axes.set_xlabel("error over the first case's (line: 95 %), log axis")
    axes.grid(axis="x", which="both", alpha=0.25)
