"""What the figures of all tests have in common."""

from typing import Any, Literal

from matplotlib.axes import Axes
from matplotlib.figure import Figure

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9")
"""Colours that are distinct for colour-blind readers too (Okabe and Ito)."""


def finish_axes(
    axes: Axes, x: str, y: str, grid: Literal["major", "both"] = "major", **limits: Any
) -> None:
    """Label axes, set limits (keywords of `Axes.set`), draw a faint grid and a legend."""
    axes.set(xlabel=x, ylabel=y, **limits)
    axes.grid(alpha=0.3, which=grid)
    axes.legend()


def move_legends(figure: Figure) -> None:
    """Put each legend to the right of its axes, where no data are."""
    for axes in figure.axes:
        if legend := axes.get_legend():
            legend.set_loc("upper left")
            legend.set_bbox_to_anchor((1.0, 1.0))
